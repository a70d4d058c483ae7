"""`carom resume` goes on with a run as if it had never stopped, and says plainly what it cannot go on from; interrupted
runs, limits and locks keep what is there; `carom convert` and `carom info` know every format."""

import fcntl
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

from program import CAROM, HAS_HDF5, TWO_DISKS, ProgramTest, main



@unittest.skipUnless(HAS_HDF5, "built without HDF5")
class ResumeTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.succeed("make", "gas", "--disks", 80, "--packing", 0.5, "-o", "gas.toml")

    def begin(self, out="o", until=2, *more):
        return self.json_of("run", "gas.toml", "--until", until, "--out", out, *more)


class Resume(ResumeTest):
    def test_as_if_never_stopped(self):
        whole = self.begin("whole", 7.3)
        self.begin()
        for words in (["--until", 3.1], ["--until", 5, "--threads", 2, "--patches", "2x2"],
                      ["--until", 6, "--solver", "reference"], ["--until", 7.3]):
            self.json_of("resume", "o", *words)
        report = json.loads(self.read("o/report.json"))
        for key in ("digest", "scene_digest", "collisions", "pressure", "windows", "max_overlap", "energy_drift"):
            self.assertEqual(report[key], whole[key], key)
        self.assertEqual(self.read("o/final.xyz"), self.read("whole/final.xyz"))
        self.assertEqual(report["ended"], "time")

    def test_granular_and_open_systems_go_on_too(self):
        for name, boundary, restitution in (("a", "reflecting", 0.9), ("b", "open", 1.0), ("c", "reflecting", 1.0)):
            self.write(f"{name}.toml", TWO_DISKS.replace('"reflecting"', f'"{boundary}"') +
                       f"\n[physics]\nrestitution = {restitution}\n")
            whole = self.json_of("run", f"{name}.toml", "--until", 300, "--out", f"whole-{name}")
            self.succeed("run", f"{name}.toml", "--until", 100, "--out", name)
            self.assertEqual(self.json_of("resume", name, "--until", 300)["digest"], whole["digest"])

    def test_measuring_that_begins_later_begins_then(self):
        whole = self.begin("whole", 9, "--equilibrate", 4)
        self.begin("o", 1, "--equilibrate", 4)
        self.assertEqual(self.json_of("resume", "o", "--until", 9)["pressure"], whole["pressure"])

    def test_collisions_count_from_the_start(self):
        whole = self.json_of("run", "gas.toml", "--collisions", 5000, "--out", "whole")
        self.begin()
        self.assertEqual(self.json_of("resume", "o", "--collisions", 5000)["digest"], whole["digest"])

    def test_without_an_end_the_first_one_counts(self):
        first = self.begin()
        self.assertEqual(self.json_of("resume", "o")["digest"], first["digest"])

    def test_a_run_without_further_collisions_stays_at_its_end(self):
        self.write("open.toml", TWO_DISKS.replace("reflecting", "open"))
        first = self.json_of("run", "open.toml", "--collisions", 10**6, "--out", "o")
        self.assertEqual(first["ended"], "exhausted")
        again = self.json_of("resume", "o")
        for key in ("ended", "time", "windows", "digest"):
            self.assertEqual(again[key], first[key], key)

    def test_a_checkpoint_by_name(self):
        whole = self.begin("whole", 4)
        self.begin()
        self.assertEqual(self.json_of("resume", "o/checkpoint-1.h5", "--until", 4)["digest"], whole["digest"])

    def test_the_log_is_appended_to(self):
        self.begin("whole", 4, "--log-collisions", "whole.csv")
        self.begin("o", 2.3, "--log-collisions", "log.csv")
        self.refuse(["resume", "o"], 2, "/log.csv", "--log-collisions")
        self.json_of("resume", "o", "--until", 4, "--log-collisions", "log.csv")
        self.assertEqual(self.read("log.csv"), self.read("whole.csv"))

    def test_only_a_log_is_cut_back(self):
        self.begin("o", 2.3, "--log-collisions", "log.csv")
        self.write("notes.txt", "x" * 10**6)
        self.refuse(["resume", "o", "--log-collisions", "notes.txt"], 1, "notes.txt", "not a log")
        self.assertEqual(len(self.read("notes.txt")), 10**6)
        self.write("log.csv", self.read("log.csv")[:100])
        self.refuse(["resume", "o", "--log-collisions", "log.csv"], 1, "log.csv", "shorter")

    def test_what_is_refused_leaves_the_newest_checkpoint(self):
        for broken, form in (("log.csv", "xyz"), ("o/trajectory.xyz", "xyz"), ("o/trajectory.h5md", "h5md")):
            self.begin("o", 2.3, "--every", 0.1, "--trajectory", form, "--log-collisions", "log.csv", "--overwrite")
            log = self.path("log.csv").read_bytes()
            shutil.copy(self.path("o/checkpoint-1.h5"), self.path("o/old.h5"))
            self.path(broken).unlink()
            if form == "h5md" or broken == "log.csv":
                self.write(broken, "no longer what it was")
            before = {path.name: path.read_bytes() for path in self.path("o").iterdir()}
            self.refuse(["resume", "o/old.h5", "--until", 4, "--log-collisions", "log.csv"], 1, broken)
            after = {path.name: path.read_bytes() for path in self.path("o").iterdir()}
            self.assertEqual(after.keys(), before.keys())
            for name in before:
                self.assertEqual(after[name], before[name], name)
            if broken != "log.csv":
                self.assertEqual(self.path("log.csv").read_bytes(), log)

    def test_a_damaged_checkpoint_gives_way_to_the_one_before(self):
        whole = self.begin("whole", 4)
        self.begin()
        for damage in (lambda b: b[:-1], lambda b: b[:2000] + bytes([b[2000] ^ 1]) + b[2001:], lambda b: b"",
                       lambda b: b[:100] + bytes([b[100] ^ 1]) + b[101:]):
            shutil.rmtree(self.path("d"), ignore_errors=True)
            shutil.copytree(self.path("o"), self.path("d"))
            path = self.path("d/checkpoint.h5")
            path.write_bytes(damage(path.read_bytes()))
            done = self.succeed("resume", "d", "--until", 4, "--json")
            self.assertEqual(json.loads(done.stdout)["digest"], whole["digest"])
            self.assertIn("d/checkpoint.h5", done.stderr)
            self.assertIn("going on from", done.stderr)

    def test_what_cannot_be_gone_on_from(self):
        self.begin()
        self.path("empty").mkdir()
        self.write("text.h5", "carom checkpoint\nversion 2\n")
        shutil.copytree(self.path("o"), self.path("bad"))
        for name in ("checkpoint.h5", "checkpoint-1.h5"):
            self.write(f"bad/{name}", "carom checkpoint\nversion 1\n")
        for words, code, part in ((["nowhere"], 1, "nowhere"), (["empty"], 1, "no checkpoint"), ([], 2, "FROM"),
                                  (["gas.toml"], 1, "not a checkpoint"), (["text.h5"], 1, "format 2"),
                                  (["bad"], 1, "damaged"), (["o", "--until", 0.001], 1, "the checkpoint is at"),
                                  (["o", "--until", "x"], 2, "--until"), (["o", "--collisions", 0], 1, "--collisions"),
                                  (["o", "--collisions", 2**63], 1, f"--collisions {2**63}: it must not"),
                                  (["o", "--checkpoint-minutes", 0], 1, "--checkpoint-minutes"),
                                  (["o", "--max-minutes", -1], 1, "--max-minutes"),
                                  (["o", "--log-collisions", "l.csv"], 2, "no log")):
            with self.subTest(words=words):
                self.refuse(["resume", *words], code, part)

    def test_a_trajectory_that_is_gone(self):
        self.begin("o", 2, "--every", 0.5)
        self.path("o/trajectory.xyz").unlink()
        self.refuse(["resume", "o", "--until", 4], 1, "trajectory.xyz")


class Limits(ResumeTest):
    def test_collisions(self):
        for words in (["run", "gas.toml"], ["sweep", "gas.toml", "--vary", "gas.seed=1,2"]):
            self.refuse([*words, "--collisions", 2**63, "--out", "o"], 1, f"--collisions {2**63}: it must not")
        self.assertFalse(self.path("o").exists())
        self.succeed("run", "gas.toml", "--collisions", 2**63 - 1, "--out", "o", "--max-minutes", 0.0001)
        self.succeed("resume", "o", "--max-minutes", 0.0001)

    def test_minutes(self):
        done = self.succeed("run", "gas.toml", "--until", 1e9, "--out", "o", "--max-minutes", 0.005, "--json")
        report = json.loads(done.stdout)
        self.assertEqual(report["ended"], "max_minutes")
        self.assertIn("carom resume o", done.stderr)
        again = self.json_of("resume", "o", "--until", report["time"] + 3)
        self.assertEqual(again["digest"], self.json_of("run", "gas.toml", "--until", report["time"] + 3)["digest"])

    def test_options_of_saving(self):
        for words, code in ((["--checkpoint-every", "1"], 2), (["--checkpoint-minutes", "1"], 2),
                            (["--checkpoint-every", "0", "--out", "o"], 1), (["--max-minutes", "0"], 1),
                            (["--trajectory", "h5md"], 2), (["--trajectory", "h5md", "--out", "o"], 2)):
            with self.subTest(words=words):
                self.refuse(["run", "gas.toml", "--until", 1, *words], code, "--")
        self.assertFalse(self.path("o").exists())

    def test_two_runs_in_one_directory(self):
        self.begin()
        held = os.open(self.path("o"), os.O_RDONLY)
        self.addCleanup(os.close, held)
        fcntl.flock(held, fcntl.LOCK_EX)
        self.refuse(["resume", "o"], 1, "o: another carom is at work here")
        self.refuse(["run", "gas.toml", "--until", 1, "--out", "o", "--overwrite"], 1, "another carom")

    def test_an_old_run_stays_if_the_new_one_cannot_start(self):
        self.begin("o", 2, "--every", 0.5)
        before = {path.name: path.read_bytes() for path in self.path("o").iterdir()}
        self.write("bad.toml", TWO_DISKS.replace("7.0", "2.5"))
        for words in (["gas.toml", "--log-collisions", "nowhere/log.csv"], ["bad.toml"]):
            self.assertEqual(self.carom("run", *words, "--until", 1, "--out", "o", "--overwrite").returncode, 1)
            self.assertEqual({path.name: path.read_bytes() for path in self.path("o").iterdir()}, before)

    def start(self, *words):
        child = subprocess.Popen([CAROM, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                 cwd=self.directory)
        self.addCleanup(child.stdout.close)
        self.addCleanup(child.stderr.close)
        self.addCleanup(child.wait)
        self.addCleanup(child.kill)
        deadline = time.monotonic() + 60
        while not self.path("o/checkpoint.h5").exists():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)
        return child

    def test_a_directory_deleted_meanwhile(self):
        child = self.start("run", "gas.toml", "--until", 1e9, "--out", "o", "--checkpoint-every", 100)
        self.path("o").rename(self.path("gone"))  # at once, whatever is being written
        errors = child.communicate(timeout=60)[1]
        self.assertEqual(child.returncode, 1)
        self.assertEqual(len(errors.splitlines()), 1, errors)
        self.assertIn("o: was deleted", errors)

    def test_interrupted_and_gone_on_with(self):
        for form in ("xyz", "h5md"):
            shutil.rmtree(self.path("o"), ignore_errors=True)
            child = self.start("run", "gas.toml", "--until", 1e9, "--out", "o", "--every", 0.5, "--trajectory", form,
                               "--json")
            child.send_signal(signal.SIGINT)
            output, errors = child.communicate(timeout=60)
            self.assertEqual(child.returncode, 130)
            self.assertIn("carom resume o", errors)
            report = json.loads(output)
            self.assertEqual(report["ended"], "interrupted")
            end = report["time"] + 2.2
            again = self.json_of("resume", "o", "--until", end)
            whole = self.begin("whole", end, "--every", 0.5, "--trajectory", form, "--overwrite")
            self.assertEqual(again["digest"], whole["digest"])
            for name in ("o", "whole"):
                self.succeed("convert", f"{name}/trajectory.{form}", f"{name}.csv")
            self.assertEqual(self.read("o.csv"), self.read("whole.csv"))


class Convert(ResumeTest):
    def test_a_checkpoint_starts_another_run(self):
        self.begin()
        info = self.json_of("info", "o/checkpoint.h5")
        self.assertEqual((info["disks"], info["until"]), (80, 2))
        self.assertGreater(info["collisions_so_far"], 0)
        self.succeed("convert", "o/checkpoint.h5", "state.toml")
        digests = {self.json_of("run", name, "--until", 1)["digest"]
                   for name in ("o/checkpoint.h5", "state.toml")}
        self.assertEqual(len(digests), 1)

    def test_the_start_of_a_run_as_a_checkpoint(self):
        self.write("scene.toml", TWO_DISKS + "[run]\nuntil = 5.0\n")
        self.path("start").mkdir()
        self.succeed("convert", "scene.toml", "start/checkpoint.h5")
        self.assertEqual(self.json_of("resume", "start")["digest"], self.json_of("run", "scene.toml")["digest"])

    def test_the_start_of_a_run_that_observes(self):
        self.write("scene.toml", TWO_DISKS + "[run]\nuntil = 50.0\n" +
                   "".join(f'[[observe]]\nname = "{name}"\n' for name in ("msd", "speeds", "pressure")))
        self.path("start").mkdir()
        self.succeed("convert", "scene.toml", "start/checkpoint.h5")
        whole = self.json_of("run", "scene.toml")
        again = self.json_of("resume", "start")
        for key in ("digest", "observables"):
            self.assertEqual(again[key], whole[key], key)

    def test_one_frame_of_many(self):
        self.begin("o", 2, "--every", 0.5, "--trajectory", "h5md")
        self.succeed("convert", "o/trajectory.h5md", "one.xyz", "--time", 1.2)
        self.assertIn(" Time=1 ", self.read("one.xyz").splitlines()[1])
        self.assertEqual(self.json_of("info", "one.xyz")["frames"], 1)
        self.refuse(["convert", "o/trajectory.h5md", "none.xyz", "--time", -1], 1, "no frame at or before")
        self.assertFalse(self.path("none.xyz").exists())

    def test_in_place(self):
        self.begin("o", 2, "--every", 0.5, "--trajectory", "h5md")
        self.succeed("convert", "o/trajectory.h5md", "a.xyz")
        self.succeed("convert", "o/trajectory.h5md", "o/trajectory.h5md")
        self.succeed("convert", "o/trajectory.h5md", "b.xyz")
        self.assertEqual(self.read("a.xyz"), self.read("b.xyz"))
        self.succeed("convert", "a.xyz", "a.xyz")
        self.assertEqual(self.read("a.xyz"), self.read("b.xyz"))

    def test_a_cut_off_frame_is_left_out(self):
        self.begin("o", 2, "--every", 0.5)
        text = self.read("o/trajectory.xyz")
        self.write("cut.xyz", text[:-100])
        info = self.json_of("info", "cut.xyz")
        self.assertEqual((info["frames"], info["cut_off"], info["last_time"]), (4, True, 1.5))
        done = self.succeed("convert", "cut.xyz", "whole.h5md")
        self.assertIn("cut off", done.stderr)
        self.assertEqual(self.json_of("info", "whole.h5md")["frames"], 4)

    def test_what_cannot_be_converted(self):
        self.begin()
        text = self.read("gas.toml")
        self.write("frames.csv", "time,id\n")
        for words, code, part in ((["gas.toml", "gas.png"], 1, "cannot convert"), (["gas.toml", "gas"], 1, "ends in"),
                                  (["frames.csv", "a.xyz"], 1, "box"),
                                  (["nowhere.xyz", "a.xyz"], 1, "nowhere"), (["gas.toml", "no/where.xyz"], 1, "no/where"),
                                  (["gas.toml", "no/where.h5md"], 1, "no/where"), (["gas.toml"], 2, "OUT")):
            with self.subTest(words=words):
                self.refuse(["convert", *words], code, part)
        self.assertEqual(self.read("gas.toml"), text)
        leftover = [path.name for path in self.directory.iterdir() if ".part-" in path.name or ".new-" in path.name]
        self.assertEqual(leftover, [])


@unittest.skipIf(HAS_HDF5, "built with HDF5")
class WithoutHdf5(ProgramTest):
    def test_what_needs_it_says_so(self):
        self.write("scene.toml", TWO_DISKS)
        self.succeed("run", "scene.toml", "--until", 1, "--out", "o")
        self.write("c.h5", b"carom checkpoint\nversion 1\nbytes 0\nxxh3 2d06800538d394c2\n".ljust(512, b"\0"))
        self.write("t.h5md", b"\x89HDF\r\n\x1a\n")
        for words in (["resume", "o"], ["run", "scene.toml", "--until", 1, "--out", "p", "--checkpoint-every", 1],
                      ["run", "scene.toml", "--until", 1, "--out", "p", "--every", 1, "--trajectory", "h5md"],
                      ["sweep", "scene.toml", "--vary", "disk.1.mass=1,2", "--until", 1, "--out", "p",
                       "--checkpoint-minutes", 1], ["info", "c.h5"], ["run", "c.h5", "--until", 1], ["info", "t.h5md"],
                      ["convert", "scene.toml", "o.h5"], ["convert", "scene.toml", "o.h5md"],
                      ["convert", "t.h5md", "o.xyz"], ["analyze", "t.h5md"]):
            with self.subTest(words=words):
                self.refuse(words, 1, "this carom was built without HDF5, which")
                self.assertFalse(self.path("p").exists())


if __name__ == "__main__":
    main()
