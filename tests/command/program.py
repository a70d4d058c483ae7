"""Runs the program under test: what the test files of this folder share."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

CAROM = os.environ["CAROM"]
SOURCE = pathlib.Path(os.environ["CAROM_SOURCE"])
SCENES = SOURCE / "scenes"
HAS_HDF5 = os.environ.get("CAROM_HDF5", "ON") not in ("OFF", "0", "FALSE", "NO")

TWO_DISKS = """
[box]
size = [10.0, 10.0]
boundary = "reflecting"

[[disk]]
position = [2.0, 5.0]
velocity = [1.0, 0.25]

[[disk]]
position = [7.0, 5.0]
velocity = [-0.5, 0.0]
"""


class ProgramTest(unittest.TestCase):
    """A test with a directory of its own, in which the program runs."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="carom-command-")
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)

    def path(self, name):
        return self.directory / name

    def write(self, name, text):
        path = self.path(name)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return name

    def read(self, name):
        return self.path(name).read_text()

    def carom(self, *words, stdin="", **options):
        """The finished process; its output as text."""
        return subprocess.run(
            [CAROM, *map(str, words)], input=stdin, text=True, capture_output=True, cwd=self.directory,
            timeout=100, check=False, **options)

    def succeed(self, *words, **options):
        done = self.carom(*words, **options)
        self.assertEqual(done.returncode, 0, f"{words}: {done.stderr}")
        return done

    def json_of(self, *words, **options):
        """What --json prints: exactly one object on stdout."""
        value = json.loads(self.succeed(*words, "--json", **options).stdout)
        self.assertIsInstance(value, dict)
        return value

    def refuse(self, words, code, *parts, **options):
        """The program ends with `code`; stderr explains it in lines of its own and contains all `parts`."""
        done = self.carom(*words, **options)
        self.assert_refused(done, code, *parts)
        return done

    def assert_refused(self, done, code, *parts):
        self.assertEqual(done.returncode, code, done)
        self.assertEqual(done.stdout, "")
        lines = done.stderr.splitlines()
        self.assertGreaterEqual(len(lines), 1, "nothing on stderr")
        for line in lines:
            self.assertTrue(line.startswith("carom: "), line)
            self.assertLess(len(line), 400, line)
        for word in ("terminate called", "what()", "Traceback", "std::", "should not happen"):
            self.assertNotIn(word, done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)
        return lines


main = unittest.main
