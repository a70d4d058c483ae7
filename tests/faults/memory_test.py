"""Whichever request for memory is not granted, and whether or not any larger one is after it: one clear error, no corrupt
file, and the run goes on from its last checkpoint to the same bits."""

import os
import resource
import shutil
import unittest

from recovery import RecoveryTest

SHIM = os.environ["CAROM_FAILING_MEMORY"]
EVERY = int(os.environ.get("CAROM_FAULTS_EVERY", "23"))  # 1: refuse every single request


class MemoryTest(RecoveryTest):
    def requests(self, **which):
        """How many requests an undisturbed run makes."""
        done = self.run_in("counted", LD_PRELOAD=SHIM, COUNT_TO=str(self.path("requests")), **which)
        self.assertEqual(done.returncode, 0, done.stderr)
        return int(self.read("requests"))

    def check_every_request(self, first, every, **which):
        """Small requests of HDF5 are granted, as it crashes without; LimitTest refuses it large ones."""
        which["MEMORY_SPARE"] = "libhdf5"
        for number in range(first, self.requests(**which) + 1, every):
            with self.subTest(number=number, which=which):
                out = "stopped"
                shutil.rmtree(self.path(out), ignore_errors=True)
                done = self.run_in(out, LD_PRELOAD=SHIM, MEMORY_FAIL_AT=str(number), **which)
                if done.returncode == 0:
                    self.assert_same_files(out)  # somebody could do without
                    continue
                self.assert_says_why(done)
                self.assert_readable(out)
                if self.has_checkpoint(out):
                    self.assert_resumes_to_the_same(out)
                else:
                    self.refuse(["resume", out], 1)

    def assert_says_why(self, done):
        lines = self.assert_refused(done, 1)
        self.assertEqual(len(lines), 1, lines)
        # HDF5 calls it by other names, and the loader of programs has its own.
        self.assertRegex(lines[0], "memory|allocat|HDF5|no process can be started")

    def test_a_single_request_fails(self):
        self.check_every_request(1, EVERY)

    def test_no_larger_ones_from_there_on(self):
        self.check_every_request(2, max(EVERY // 4, 1), MEMORY_LEAST="2048", MEMORY_REST="1")


class MemoryOfH5mdTest(MemoryTest):
    FORMAT = "h5md"


class LimitTest(RecoveryTest):
    def test_more_than_the_process_may_have(self):
        """A scene that does not fit into the memory allowed, and one that does not any more while it runs."""
        self.succeed("make", "gas", "--disks", 100000, "--packing", 0.5, "-o", "large.toml")
        for megabytes in (44, 48, 52, 60, 80):
            with self.subTest(megabytes=megabytes):
                shutil.rmtree(self.path("o"), ignore_errors=True)
                size = megabytes << 20
                done = self.carom("run", "large.toml", "--collisions", 1, "--out", "o", "--quiet",
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size)))
                if done.returncode == 0:
                    continue
                lines = self.assert_refused(done, 1)
                self.assertEqual(len(lines), 1, lines)
                self.assertRegex(lines[0], "out of memory.*")
                self.assertTrue("large.toml" in lines[0] or "o: " in lines[0], lines)


if __name__ == "__main__":
    unittest.main()
