#!/usr/bin/python3
"""scripts/check-includes and scripts/check-flags accept a tree that keeps to the rules and refuse, with file and
reason, each way of breaking them."""

import json
import subprocess
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"


def run(script, *arguments):
    return subprocess.run([SCRIPTS / script, *arguments], capture_output=True, text=True, check=False)


class Tree(unittest.TestCase):
    """A small tree of three concepts that keeps to the rules; each test breaks it in one place."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="carom tree ")
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.write("cmake/concepts.txt", "# a comment\n0 base :\n1 rule : base\n1 state : base\n2 run : base rule\n")
        for concept in ("base", "rule", "state", "run"):
            self.write(f"src/{concept}/CMakeLists.txt", f"carom_concept({concept} SOURCES a.cpp)\n")
            self.write(f"include/carom/{concept}/a.hpp", "#pragma once\n#include <vector>\n")
        self.write("src/run/private.hpp", "#pragma once\n")
        self.write("src/run/a.cpp", '#include "carom/run/a.hpp"\n#include "carom/base/a.hpp"\n#include "private.hpp"\n')
        self.write("apps/carom/main.cpp", '#include "carom/run/a.hpp"\n')

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


class CheckIncludes(Tree):
    def refuses(self, *fragments):
        result = run("check-includes", "--root", self.root)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        for fragment in fragments:
            self.assertIn(fragment, result.stderr)

    def test_accepts_a_tree_that_keeps_to_the_table(self):
        result = run("check-includes", "--root", self.root)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_refuses_an_include_upwards(self):
        self.write("include/carom/base/a.hpp", '#pragma once\n\n#include "carom/run/a.hpp"\n')
        self.refuses("include/carom/base/a.hpp:3:", "'base' may not include carom/run/a.hpp")

    def test_refuses_an_include_sideways(self):
        self.write("src/rule/a.cpp", '#include "carom/state/a.hpp"\n')
        self.refuses("src/rule/a.cpp:1:", "'rule' may not include")

    def test_refuses_a_public_header_that_includes_a_private_one(self):
        self.write("include/carom/run/a.hpp", '#include "private.hpp"\n')
        self.refuses("include/carom/run/a.hpp:1:", "private")

    def test_refuses_a_private_header_of_another_folder(self):
        self.write("src/state/a.cpp", '#include "../run/private.hpp"\n')
        self.write("apps/carom/main.cpp", '#include "../../src/run/private.hpp"\n')
        self.refuses("src/state/a.cpp:1:", "apps/carom/main.cpp:1:", "is private to another folder")

    def test_refuses_a_header_that_is_not_there(self):
        self.write("apps/carom/main.cpp", '#include "carom/run/b.hpp"\n')
        self.refuses("apps/carom/main.cpp:1:", "there is no public header carom/run/b.hpp")

    def test_refuses_headers_that_include_each_other(self):
        self.write("include/carom/run/a.hpp", '#include "carom/run/b.hpp"\n')
        self.write("include/carom/run/b.hpp", '#include "carom/run/a.hpp"\n')
        self.refuses("circle: ")

    def test_refuses_a_link_by_hand(self):
        for link in ("carom::state", "carom_state"):
            self.write("src/run/CMakeLists.txt", f"carom_concept(run SOURCES a.cpp\n  PRIVATE_LINKS {link})\n")
            self.refuses("src/run/CMakeLists.txt:2:", "'state'")

    def test_refuses_a_library_that_is_not_made_from_the_table(self):
        self.write("src/run/CMakeLists.txt", "add_library(carom_run a.cpp)\n")
        self.refuses("src/run/CMakeLists.txt:1:", "carom_concept(run")

    def test_refuses_a_folder_without_a_row(self):
        self.write("src/utils/a.cpp", "")
        self.refuses("src/utils:1:", "without a row")

    def test_refuses_a_table_that_points_sideways_or_down(self):
        self.write("cmake/concepts.txt", "0 base :\n1 rule : base state\n1 state : base rule\n2 run : base\n")
        self.refuses("concepts.txt:2:", "concepts.txt:3:")

    def test_map_lists_every_concept(self):
        result = run("check-includes", "--root", self.root, "--map")
        self.assertEqual(result.returncode, 0, result.stderr)
        for row in ("| 0     | base ", "| 2     | run      | base rule "):
            self.assertIn(row, result.stdout)


class CheckFlags(Tree):
    def check(self, flags, form="command"):
        command = f"c++ {flags} -c 'a b.cpp'"
        entry = {"directory": "/", "file": "a b.cpp"}
        entry[form] = command if form == "command" else command.split()
        self.write("compile_commands.json", json.dumps([entry]))
        return run("check-flags", self.root)

    def test_accepts_contraction_off(self):
        for flags in ("-O3 -ffp-contract=off", "-ffp-contract=fast -O2 -ffp-contract=off"):
            for form in ("command", "arguments"):
                self.assertEqual(self.check(flags, form).returncode, 0, flags)

    def test_refuses_contraction(self):
        for flags in ("-O3", "-ffp-contract=fast", "-ffp-contract=off -ffp-contract=on"):
            for form in ("command", "arguments"):
                result = self.check(flags, form)
                self.assertEqual(result.returncode, 1, flags)
                self.assertIn("a b.cpp: ", result.stderr)

    def test_refuses_options_that_change_results(self):
        for flag in ("-ffast-math", "-Ofast", "-funsafe-math-optimizations", "-fassociative-math",
                     "-freciprocal-math", "-ffinite-math-only", "-march=native", "-mfma"):
            result = self.check(f"{flag} -ffp-contract=off")
            self.assertEqual(result.returncode, 1, flag)
            self.assertIn(f"has {flag}", result.stderr)

    def test_refuses_a_build_without_translation_units(self):
        self.write("compile_commands.json", "[]")
        self.assertEqual(run("check-flags", self.root).returncode, 1)
        self.assertEqual(run("check-flags", self.root / "nowhere").returncode, 2)


if __name__ == "__main__":
    unittest.main()
