"""Whichever call fails that changes a file (a full disk, a failing disk, a kill in its place): one clear error, no
corrupt file, and the run goes on from its last checkpoint to the same bits."""

import errno
import os
import shutil
import unittest

from recovery import RecoveryTest

SHIM = os.environ["CAROM_FAILING_WRITES"]
EVERY = int(os.environ.get("CAROM_FAULTS_EVERY", "5"))  # 1: fail every single call


class WritesTest(RecoveryTest):
    def calls(self):
        """How many calls change files in an undisturbed run."""
        done = self.run_in("counted", LD_PRELOAD=SHIM, COUNT_TO=str(self.path("calls")))
        self.assertEqual(done.returncode, 0, done.stderr)
        return int(self.read("calls"))

    def disturb(self, out, number, **how):
        return self.run_in(out, LD_PRELOAD=SHIM, FAIL_AT=str(number), **how)

    def check_every_call(self, first, **how):
        for number in range(first, self.calls() + 1, EVERY):
            with self.subTest(number=number, how=how):
                out = "stopped"
                shutil.rmtree(self.path(out), ignore_errors=True)
                done = self.disturb(out, number, **how)
                if "KILL" in how:
                    self.assertEqual(done.returncode, -9)
                elif done.returncode == 0:
                    self.assert_same_files(out)  # the trial of the directory, or a sync that may fail
                    continue
                else:
                    lines = self.assert_refused(done, 1, os.strerror(int(how.get("FAIL_WITH", errno.ENOSPC))))
                    self.assertEqual(len(lines), 1, lines)
                self.assert_readable(out)
                if self.has_checkpoint(out):
                    self.assert_resumes_to_the_same(out)
                else:
                    self.refuse(["resume", out], 1, "no checkpoint")

    def test_the_disk_is_full_from_there_on(self):
        self.check_every_call(1, FAIL_REST="1")

    def test_a_single_call_fails(self):
        self.check_every_call(2, FAIL_WITH=str(errno.EIO))

    def test_killed_there(self):
        self.check_every_call(3, KILL="1")

    def test_killed_while_going_on(self):
        """The same for the resumed run: files are shortened there before they grow again."""
        calls = self.calls()
        for number in range(1, calls, 4 * EVERY):
            with self.subTest(number=number):
                out = "stopped"
                shutil.rmtree(self.path(out), ignore_errors=True)
                self.disturb(out, 2 * calls // 3, KILL="1")
                done = self.carom("resume", out, "--json", env={**os.environ, "LD_PRELOAD": SHIM, "KILL": "1",
                                                                "FAIL_AT": str(number)})
                self.assertIn(done.returncode, (-9, 0))
                self.assert_readable(out)
                self.assert_resumes_to_the_same(out)

    def check_going_on_from_the_one_before(self, damaged, name):
        """Of two checkpoints the older one is gone on from, and that is killed, too."""
        self.disturb("base", 2 * self.calls() // 3, KILL="1")
        newest = self.path("base/checkpoint.h5")
        if damaged:
            newest.write_bytes(newest.read_bytes()[:-1])
        number, ended = 1, False
        while not ended:
            with self.subTest(number=number, damaged=damaged):
                shutil.rmtree(self.path("stopped"), ignore_errors=True)
                shutil.copytree(self.path("base"), self.path("stopped"))
                done = self.carom("resume", name, "--json", env={**os.environ, "LD_PRELOAD": SHIM, "KILL": "1",
                                                                 "FAIL_AT": str(number)})
                ended = done.returncode == 0
                self.assertIn(done.returncode, (-9, 0))
                self.assert_resumes_to_the_same("stopped")
            number += 1 if number < 20 else 4 * EVERY  # it begins with what is to be tested

    def test_killed_while_going_on_from_the_one_before_a_damaged_one(self):
        self.check_going_on_from_the_one_before(True, "stopped")

    def test_killed_while_going_on_from_the_older_one(self):
        self.check_going_on_from_the_one_before(False, "stopped/checkpoint-1.h5")


class WritesOfH5mdTest(WritesTest):
    FORMAT = "h5md"


if __name__ == "__main__":
    unittest.main()
