"""A run that is killed (SIGKILL) at random moments, again and again, ends in the bits of one that was never stopped, and
no file is unreadable in between.

CAROM_KILLS says how many kills (50 by default); scripts/soak makes a thousand."""

import os
import random
import shutil
import signal
import time
import unittest

from recovery import RecoveryTest

KILLS = int(os.environ.get("CAROM_KILLS", "50"))
SEED = 20240607


class KillTest(RecoveryTest):
    """Every run is killed up to three times, then goes on to its end."""

    def kill_after(self, seconds, *words):
        """Whether the process was still there to be killed."""
        child = self.start(*words)
        time.sleep(seconds)
        killed = child.poll() is None
        child.send_signal(signal.SIGKILL)
        child.wait()
        return killed

    def duration(self, *words):
        begin = time.monotonic()
        self.succeed(*words)
        return time.monotonic() - begin

    def test_killed_at_random(self):
        generator = random.Random(SEED)
        whole = self.duration(*self.words("timed"))
        kills = 0
        while kills < KILLS:
            out = "stopped"
            shutil.rmtree(self.path(out), ignore_errors=True)
            words = self.words(out)
            for _ in range(generator.randint(1, 3)):
                kills += self.kill_after(generator.uniform(0, whole), *words)
                self.assert_readable(out)
                words = ["resume", out, "--quiet"] if self.has_checkpoint(out) else [*self.words(out), "--overwrite"]
            with self.subTest(kills=kills):
                self.succeed(*words)
                self.assert_same_files(out)


class KillOfH5mdTest(KillTest):
    FORMAT = "h5md"


if __name__ == "__main__":
    unittest.main()
