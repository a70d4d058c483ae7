"""Every command that the help texts, README.md and docs/*.md show works as shown: the program succeeds, prints what is
printed there, and the C++ and scenes shown are real."""

import os
import re
import shlex
import shutil
import subprocess

from program import CAROM, HAS_HDF5, SOURCE, ProgramTest, main

DOCUMENTS = [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))]
BLOCK = re.compile(r"^```(\w*)[^\n]*\n(.*?)^```[^\n]*\n", re.MULTILINE | re.DOTALL)


def blocks(document):
    """(language, text, language and text of a block that follows with nothing but blank lines between)."""
    text = document.read_text()
    found = list(BLOCK.finditer(text))
    for block, following in zip(found, [*found[1:], None]):
        adjacent = following and not text[block.end():following.start()].strip()
        yield block[1], block[2], (following[1], following[2]) if adjacent else None


def commands(shell_text):
    """The lines of a shell block, those that go on after a backslash joined."""
    return [line.strip() for line in shell_text.replace("\\\n", " ").splitlines()]


def is_possible(line):
    """Checkpoints and H5MD files need HDF5; without it resume_test.py sees to it that this is said."""
    return HAS_HDF5 or not re.search(r"\bresume\b|\.h5\b|h5md", line)


class DocumentedTest(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(SOURCE / "scenes", self.path("scenes"))
        self.path("bin").mkdir()
        self.path("bin/carom").symlink_to(CAROM)

    def shell(self, line):
        if line.startswith("carom lab"):  # serves until it is interrupted: lab_test.py does that
            line = "carom lab --help"
        return subprocess.run(["/bin/sh", "-c", line], cwd=self.directory, text=True, capture_output=True, timeout=300,
                              env={**os.environ, "PATH": f"{self.path('bin')}:/usr/bin:/bin", "LC_ALL": "C.UTF-8"})


class Help(DocumentedTest):
    def helps(self, *words):
        """The help of a command and of those below it."""
        text = self.succeed(*words, "--help").stdout
        yield words, text
        if "Subcommands:" in text:
            for name in re.findall(r"^  ([a-z-]+)", text.split("Subcommands:")[1].split("Example")[0], re.MULTILINE):
                yield from self.helps(*words, name)

    def test_every_command_has_an_example_that_works(self):
        seen = 0
        for words, text in self.helps():
            with self.subTest(command=words):
                seen += 1
                self.assertIn("Example", text)
                examples = [line for line in commands(text.split("Example")[1]) if line.startswith("carom ")]
                self.assertGreaterEqual(len(examples), 1)
                for example in filter(is_possible, examples):
                    done = self.shell(example)
                    self.assertEqual(done.returncode, 0, f"{example}: {done.stderr}")
        self.assertGreaterEqual(seen, 14)


def shown_matches(shown, printed):
    """Whether `printed` is `shown`, in which a line of "..." stands for any lines."""
    parts = [re.escape(part) for part in re.split(r"^\.\.\.\n", shown, flags=re.MULTILINE)]
    return re.fullmatch(r"(?:.*\n)*?".join(parts), printed) is not None


class Documents(DocumentedTest):
    def test_commands_in_shell_blocks(self):
        seen = 0
        for document in DOCUMENTS:
            for language, text, following in blocks(document):
                if language != "sh":
                    continue
                printed = ""
                for line in commands(text):
                    if not line.startswith("carom ") or not is_possible(line):
                        continue
                    seen += 1
                    with self.subTest(document=document.name, line=line):
                        self.assertTrue(shlex.split(line, comments=True))
                        done = self.shell(line)
                        self.assertEqual(done.returncode, 0, done.stderr)
                        printed += done.stdout
                if following and following[0] == "text":
                    with self.subTest(document=document.name, output_of=text):
                        self.assertTrue(shown_matches(following[1], printed), f"shown:\n{following[1]}got:\n{printed}")
        self.assertGreater(seen, 0)

    def test_every_option_shown_for_carom_exists(self):
        for document in DOCUMENTS:
            for command, option in re.findall(r"`carom ([a-z]+)[^`\n]*?(--[a-z-]+)", document.read_text()):
                with self.subTest(document=document.name, command=command, option=option):
                    done = self.carom(command, "--help")
                    helps = done.stdout + (self.carom("make", "gas", "--help").stdout if command == "make" else "")
                    if command == "make":
                        helps += "".join(self.carom("make", name, "--help").stdout for name in ("galperin", "cradle"))
                    self.assertIn(option, helps)

    def test_cpp_is_part_of_an_example(self):
        examples = [path.read_text() for path in (SOURCE / "examples").glob("*.cpp")]
        for document in (SOURCE / "README.md", SOURCE / "docs/library.md"):
            for language, text, _ in blocks(document):
                if language == "cpp":
                    with self.subTest(document=document.name, text=text):
                        self.assertTrue(any(text in example for example in examples), "in no examples/*.cpp")

    def test_scenes_are_valid(self):
        for document in DOCUMENTS:
            for language, text, _ in blocks(document):
                if language == "toml" and re.search(r"^\[\[(disk|gas)\]\]", text, re.MULTILINE):
                    with self.subTest(document=document.name, text=text):
                        self.write("shown.toml", text)
                        self.succeed("check", "shown.toml")


class Matching(DocumentedTest):
    def test_outputs_are_compared_word_for_word(self):
        self.assertTrue(shown_matches("a\n...\nd\n", "a\nb\nc\nd\n"))
        self.assertTrue(shown_matches("a\n...\n", "a\nb\n"))
        self.assertFalse(shown_matches("a\n...\nd\n", "a\nb\nc\n"))
        self.assertFalse(shown_matches("a.c\n", "abc\n"))
        self.assertFalse(shown_matches("a\n", "a\nb\n"))


if __name__ == "__main__":
    main()
