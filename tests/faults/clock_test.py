"""Somebody sets the system's clock back and forth by years: limits of time by the clock hold, no run ends early, and
bits do not change."""

import json
import os
import signal
import subprocess
import sys
import time
import unittest

from recovery import RecoveryTest

JUMPS = {"LD_PRELOAD": os.environ["CAROM_JUMPING_CLOCK"], "CLOCK_JUMP": "100000000"}
BACK = {**JUMPS, "CLOCK_JUMP": "-100000000"}


class ClockTest(RecoveryTest):
    def test_the_clock_does_jump(self):
        """Else the other tests would say nothing."""
        for variables in (JUMPS, BACK):
            done = subprocess.run([sys.executable, "-c", "import time; print(time.time(), time.time())"], text=True,
                                  env={**os.environ, **variables}, capture_output=True, check=True)
            first, second = map(float, done.stdout.split())
            self.assertGreater(abs(first - second), 1e7)

    def test_a_run_does_not_end_early(self):
        for variables in (JUMPS, BACK):
            done = self.run_in("o", "--max-minutes", 100, "--overwrite", **variables)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual((done.report["ended"], done.report["digest"]), ("time", self.reference["digest"]))
            self.assertGreaterEqual(done.report["wall_seconds"], 0)
            self.assert_same_files("o")

    def test_minutes_are_over_all_the_same(self):
        for variables in (JUMPS, BACK):
            done = self.carom("run", "gas.toml", "--until", 1e9, "--max-minutes", 0.005, "--json",
                              env={**os.environ, **variables})
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(json.loads(done.stdout)["ended"], "max_minutes")

    def test_checkpoints_are_written_all_the_same(self):
        for out, variables in (("forward", JUMPS), ("back", BACK)):
            child = self.start("run", "gas.toml", "--until", 1e9, "--out", out, "--quiet",
                               "--checkpoint-minutes", 0.001, variables=variables)
            try:
                deadline = time.monotonic() + 60
                while not self.path(f"{out}/checkpoint-1.h5").exists():  # one was written while the run went on
                    self.assertLess(time.monotonic(), deadline)
                    time.sleep(0.02)
            finally:
                child.send_signal(signal.SIGKILL)
                child.wait()
            self.assertGreater(self.json_of("info", f"{out}/checkpoint.h5")["collisions_so_far"], 0)


if __name__ == "__main__":
    unittest.main()
