"""`carom sweep` makes a run of its own for every point and replica, with a seed of its own; its tables are the same
bytes for any number of threads and wherever it was interrupted or killed; it refuses what it cannot do before it begins."""

import csv
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

from program import CAROM, HAS_HDF5, ProgramTest, main

GAS = """
[box]
boundary = "periodic"

[[gas]]
count = 40
packing_fraction = 0.3
"""

TABLES = ("sweep.csv", "sweep_mean.csv")


class SweepTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("gas.toml", GAS)

    def sweep(self, out, *words, vary=("packing=0.2:0.4:0.1",), collisions=300, **options):
        varied = [word for key in vary for word in ("--vary", key)]
        return self.succeed("sweep", "gas.toml", *varied, "--collisions", collisions, "--out", out, *words, **options)

    def rows(self, name):
        return list(csv.DictReader(self.read(name).splitlines()))

    def tables(self, out):
        return [self.read(f"{out}/{name}") for name in TABLES]


class Jobs(SweepTest):
    def test_each_is_a_run_of_its_own(self):
        self.sweep("o", "--replicas", 2)
        rows = self.rows("o/sweep.csv")
        self.assertEqual([row["packing"] for row in rows], ["0.2", "0.2", "0.3", "0.3", "0.4", "0.4"])
        self.assertEqual([row["replica"] for row in rows], ["1", "2"] * 3)
        self.assertEqual(len({row["seed"] for row in rows}), 6)
        self.assertEqual(len({row["digest"] for row in rows}), 6)
        for row in rows:
            directory = f"o/runs/packing={row['packing']},replica={row['replica']}"
            report = json.loads(self.read(f"{directory}/report.json"))
            self.assertEqual(row["digest"], report["digest"])
            for key in ("disks", "packing_fraction", "time", "collisions", "temperature", "pressure"):
                self.assertEqual(float(row[key]), report[key], key)
            self.assertAlmostEqual(report["packing_fraction"], float(row["packing"]), delta=1e-12)
            # The scene that was kept runs to the same end.
            self.assertEqual(self.json_of("run", f"{directory}/scene.toml")["digest"], row["digest"])
            density = float(row["packing_fraction"]) / (3.141592653589793 * 0.25)
            self.assertAlmostEqual(float(row["Z"]), float(row["pressure"]) / density, delta=1e-9)

    def test_means_and_standard_errors(self):
        self.sweep("o", "--replicas", 3)
        rows = self.rows("o/sweep.csv")
        for mean in self.rows("o/sweep_mean.csv"):
            values = [float(row["pressure"]) for row in rows if row["packing"] == mean["packing"]]
            self.assertEqual((len(values), mean["replicas"]), (3, "3"))
            average = sum(values) / 3
            error = (sum((value - average)**2 for value in values) / 2 / 3)**0.5
            self.assertAlmostEqual(float(mean["pressure"]), average, delta=1e-12)
            self.assertAlmostEqual(float(mean["pressure_error"]), error, delta=1e-12)

    def test_a_grid(self):
        self.sweep("o", vary=("packing=0.2,0.3", "restitution=0.9,1"), collisions=50)
        points = [(row["packing"], row["restitution"]) for row in self.rows("o/sweep.csv")]
        self.assertEqual(points, [("0.2", "0.9"), ("0.2", "1"), ("0.3", "0.9"), ("0.3", "1")])

    def test_keys(self):
        expected = {
            "temperature=2,3": lambda row: float(row["gas.temperature"]) - float(row["temperature"]),
            "disks=30:50:10": lambda row: float(row["gas.count"]) - float(row["disks"]),
            "seed=5,6": lambda row: float(row["gas.seed"]) - float(row["seed"]),
            "gas.packing_fraction=0.2,0.25": lambda row: float(row["gas.packing_fraction"]) - float(row["packing_fraction"]),
        }
        for number, (vary, difference) in enumerate(expected.items()):
            with self.subTest(vary=vary):
                self.sweep(f"o{number}", vary=(vary,), collisions=20)
                for row in self.rows(f"o{number}/sweep.csv"):
                    self.assertAlmostEqual(difference(row), 0, delta=1e-9)
        for number, vary in enumerate(("aspect=0.5,2", "radius=0.5,1", "mass=2,3", "wall_restitution=0.5,1",
                                       "physics.t_c=0,0.1", "run.equilibrate=0,0.1", "gas.1.mass=1,2")):
            with self.subTest(vary=vary):
                self.sweep(f"p{number}", vary=(vary,), collisions=20)
                self.assertEqual(len(self.rows(f"p{number}/sweep.csv")), 2)

    def test_ranges_hold_round_numbers_and_their_end(self):
        for text, values in (("0.1:0.4:0.1", "0.1 0.2 0.3 0.4"), ("0.4:0.1:-0.15", "0.4 0.25 0.1"),
                             ("0.1:0.39:0.1", "0.1 0.2 0.3"), ("0.3:0.3:1", "0.3"), ("0.2,0.1", "0.2 0.1")):
            out = "o" + text.replace(":", "_")
            self.sweep(out, vary=(f"packing={text}",), collisions=1)
            self.assertEqual([row["packing"] for row in self.rows(f"{out}/sweep.csv")], values.split())

    def test_observables_have_columns(self):
        self.sweep("o", "--observe", "pressure", "--replicas", 2)
        row = self.rows("o/sweep.csv")[0]
        names = [name for name in row if name.startswith("pressure.")]
        self.assertGreaterEqual(len(names), 2)
        for name in names:
            self.assertTrue(name.endswith("_error") or f"{name}_error" in names, name)
        index = json.loads(self.read("o/runs/packing=0.2,replica=1/observables/index.json"))
        for estimate in index["observables"][0]["estimates"]:
            self.assertEqual(float(row["pressure." + estimate["name"]]), estimate["value"])

    def test_summary(self):
        summary = self.json_of("sweep", "gas.toml", "--vary", "packing=0.2,0.3", "--collisions", 20, "--out", "o")
        self.assertEqual((summary["jobs"], summary["finished"], summary["kept"]), (2, 2, 0))
        for plot in summary["plots"]:
            self.assertTrue(self.path(plot).exists())
        self.assertIn("o/plots/equation_of_state.svg", summary["plots"])


class SameBytes(SweepTest):
    def test_for_any_number_of_threads(self):
        self.sweep("one", "--replicas", 2, "--observe", "rate")
        self.sweep("three", "--replicas", 2, "--observe", "rate", "--threads", 3)
        self.assertEqual(self.tables("one"), self.tables("three"))

    def test_finished_jobs_are_kept_and_others_made_again(self):
        self.sweep("o", "--replicas", 2)
        tables = self.tables("o")
        runs = sorted(self.path("o/runs").iterdir())
        for name in TABLES:
            self.path(f"o/{name}").unlink()
        (runs[0] / "job.json").unlink()
        (runs[1] / "report.json").unlink()
        (runs[2] / "report.json").write_text((runs[2] / "report.json").read_text()[:100])
        (runs[3] / "job.json").write_text("{}")
        shutil.rmtree(runs[4])
        kept = (runs[5] / "report.json").stat().st_mtime_ns
        again = json.loads(self.sweep("o", "--replicas", 2, "--threads", 2, "--json").stdout)
        self.assertEqual((again["finished"], again["kept"]), (6, 1))
        self.assertEqual(self.tables("o"), tables)
        self.assertEqual((runs[5] / "report.json").stat().st_mtime_ns, kept)



class Stopped(SweepTest):
    """The first two jobs are done in no time, the other two are not."""
    WORDS = ["sweep", "gas.toml", "--vary", "run.collisions=100,200,900000,600000", "--observe", "rate,msd,pressure",
             *(["--checkpoint-minutes", "1e-3"] if HAS_HDF5 else []), "--out"]
    LONG = ("o/runs/run.collisions=900000,replica=1", "o/runs/run.collisions=600000,replica=1")

    def start(self, *more):
        return subprocess.Popen([CAROM, *self.WORDS, "o", *map(str, more)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, cwd=self.directory)

    def wait_until(self, condition):
        deadline = time.monotonic() + 60
        while not condition():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.001)

    def collisions_in(self, directory):
        """Those before the newest checkpoint."""
        return self.json_of("info", f"{directory}/checkpoint.h5")["collisions_so_far"] if HAS_HDF5 else 0

    def stop(self, number, *more):
        """Sends the signal while the long jobs run: two at a time, or the third."""
        # Written when the job begins or goes on: by then the program heeds signals.
        sign = self.path(f"{self.LONG[0]}/{'checkpoint.h5' if HAS_HDF5 else 'scene.toml'}")
        before = sign.stat().st_mtime_ns if sign.exists() else 0
        child = self.start(*more)
        self.wait_until(lambda: (sign.exists() and sign.stat().st_mtime_ns != before) or child.poll() is not None)
        time.sleep(0.1)  # beyond the checkpoint at the job's start
        child.send_signal(number)
        _, errors = child.communicate(timeout=60)
        return child.returncode, errors

    def test_after_an_interrupt(self):
        self.succeed(*self.WORDS, "whole")
        code, errors = self.stop(signal.SIGINT)
        self.assertEqual(code, 130, errors)
        self.assertIn("carom: interrupted", errors)
        # The tables hold what is finished; what was interrupted does not look so.
        self.assertEqual(self.read("o/sweep.csv"), "".join(self.read("whole/sweep.csv").splitlines(True)[:3]))
        third = self.path(self.LONG[0])
        self.assertFalse((third / "report.json").exists() or (third / "job.json").exists())
        if HAS_HDF5:
            self.assertGreater(self.collisions_in(self.LONG[0]), 1000)
        done = json.loads(self.succeed(*self.WORDS, "o", "--threads", 2, "--json").stdout)
        self.assertEqual((done["kept"], done["resumed"]), (2, 1 if HAS_HDF5 else 0))
        self.assertEqual(self.tables("o"), self.tables("whole"))

    def test_interrupted_and_killed_again_and_again(self):
        self.succeed(*self.WORDS, "whole")
        threads = (2, 1, 3, 2)
        before = [0, 0]
        for count, number in zip(threads, (signal.SIGINT, signal.SIGKILL, signal.SIGTERM, signal.SIGKILL)):
            code, errors = self.stop(number, "--threads", count)
            self.assertIn(code, (130, -9), errors)
            # None begins anew.
            after = [self.collisions_in(job) if self.path(f"{job}/checkpoint.h5").exists() else 0 for job in self.LONG]
            for old, new in zip(before, after):
                self.assertGreaterEqual(new, old)
            before = after
        self.assertTrue(before[0] > 1000 or not HAS_HDF5)
        done = json.loads(self.succeed(*self.WORDS, "o", "--json").stdout)
        self.assertEqual((done["finished"], done["resumed"]), (4, 2 if HAS_HDF5 else 0))
        self.assertEqual(self.tables("o"), self.tables("whole"))
        for job in self.LONG:
            whole = job.replace("o/", "whole/", 1)
            for name in ("final.xyz", "observables/msd.csv", "scene.toml"):
                self.assertEqual(self.read(f"{job}/{name}"), self.read(f"{whole}/{name}"))

    @unittest.skipUnless(HAS_HDF5, "there are no checkpoints without HDF5")
    def test_damaged_and_foreign_checkpoints(self):
        self.succeed(*self.WORDS, "whole")
        self.stop(signal.SIGINT)
        newest = self.path(f"{self.LONG[0]}/checkpoint.h5")
        previous = self.path(f"{self.LONG[0]}/checkpoint-1.h5")
        bytes_before = newest.read_bytes()
        newest.write_bytes(bytes_before[:-100])
        done = self.succeed(*self.WORDS, "o", "--json")
        self.assertIn("checkpoint.h5: the checkpoint is damaged", done.stderr)
        self.assertEqual(json.loads(done.stdout)["resumed"], 1)
        self.assertEqual(self.tables("o"), self.tables("whole"))
        # With neither whole nothing is thrown away.
        self.path(f"{self.LONG[0]}/job.json").unlink()
        for path in (newest, previous):
            path.write_bytes(path.read_bytes()[:-100])
        done = self.carom(*self.WORDS, "o")
        self.assertEqual(done.returncode, 1)
        self.assertIn("run.collisions=900000,replica=1: ", done.stderr)
        self.assertTrue(newest.exists() and previous.exists())
        # One of another run is not gone on with.
        for path in (newest, previous):
            path.write_bytes(self.path(f"whole/runs/run.collisions=600000,replica=1/{path.name}").read_bytes())
        done = json.loads(self.succeed(*self.WORDS, "o", "--json").stdout)
        self.assertEqual((done["kept"], done["resumed"]), (3, 0))
        self.assertEqual(self.tables("o"), self.tables("whole"))


class WrongInput(SweepTest):
    def test_variations(self):
        for vary, part in (("packing", "KEY=FROM:TO:STEP"), ("packing=", "KEY="), ("=1:2:1", "KEY="),
                           ("packing=0.1:0.2", "FROM:TO:STEP"), ("packing=0.1:0.2:0.1:3", "FROM:TO:STEP"),
                           ("packing=0.1:0.2:0", "step is 0"), ("packing=0.1:0.2:-0.1", "do not lead"),
                           ("packing=0.1:nan:0.1", "not a finite number"), ("packing=0.1:inf:0.1", "not a finite number"),
                           ("packing=a:b:c", "not a finite number"), ("packing=0.2,0.2", "twice"),
                           ("packing=0:1:1e-9", "more than"), ("paking=0.1,0.2", "'paking'"),
                           ("gas.2.mass=1,2", "numbered from 1 to 1"), ("disks=10.5,11", "whole number"),
                           ("mass_ratio=1,2", "fewer than 2"), ("disk.mass=1,2", "no [[disk]]"),
                           ("observe.rdf.bins=1,2", "'rdf'"), ("../x=1,2", "'../x'")):
            with self.subTest(vary=vary):
                self.refuse(["sweep", "gas.toml", "--vary", vary, "--collisions", 10, "--out", "o"], 2, part)
                self.assertFalse(self.path("o").exists())

    def test_options(self):
        words = ["sweep", "gas.toml", "--vary", "packing=0.2,0.3", "--out", "o"]
        self.refuse(words, 2, "--until", "--collisions")
        for more, part in ((["--replicas", 0], "--replicas"), (["--threads", 0], "--threads"),
                           (["--observe", "nonsense"], "nonsense"), (["--until", -1], "--until")):
            self.refuse([*words, "--collisions", 10, *more], 2, part)
        self.refuse(["sweep", "gas.toml", "--out", "o", "--collisions", 10], 2, "--vary")
        self.refuse(["sweep", "gas.toml", "--vary", "packing=0.2,0.3", "--collisions", 10], 2, "--out")
        self.refuse([*words, "--vary", "packing=0.1,0.2", "--collisions", 10], 2, "twice")
        self.refuse(["sweep", "gas.toml", "--vary", "seed=1,2", "--replicas", 2, "--collisions", 10, "--out", "o"], 2,
                    "seeds are varied")
        self.assertFalse(self.path("o").exists())

    def test_scenes_that_cannot_be_simulated(self):
        for vary, part in (("packing=0.5,0.95", "packing=0.95"), ("restitution=0.5,1.5", "restitution=1.5")):
            self.refuse(["sweep", "gas.toml", "--vary", vary, "--collisions", 10, "--out", "o"], 1, part)
            self.assertFalse(self.path("o").exists())

    def test_replicas_of_a_scene_without_chance(self):
        self.write("disks.toml", "[[disk]]\nposition = [1.0, 1.0]\n[box]\nsize = [4.0, 4.0]\n[run]\nuntil = 1.0\n")
        self.refuse(["sweep", "disks.toml", "--vary", "disk.mass=1,2", "--replicas", 2, "--out", "o"], 2, "no [[gas]]")
        self.succeed("sweep", "disks.toml", "--vary", "disk.mass=1,2", "--out", "o")

    def test_other_settings_in_the_same_directory(self):
        self.sweep("o", collisions=20)
        tables = self.tables("o")
        for more in (["--collisions", 21], ["--collisions", 20, "--replicas", 2], ["--collisions", 20, "--seed", 9]):
            self.refuse(["sweep", "gas.toml", "--vary", "packing=0.2:0.4:0.1", "--out", "o", *more], 1, "o", "other settings")
        self.refuse(["sweep", "gas.toml", "--vary", "packing=0.2,0.3", "--collisions", 20, "--out", "o"], 1, "varied")
        self.assertEqual(self.tables("o"), tables)
        self.succeed("run", "gas.toml", "--collisions", 5, "--out", "run")
        self.refuse(["sweep", "gas.toml", "--vary", "packing=0.2,0.3", "--collisions", 20, "--out", "run"], 1, "a run")


class AnotherSweep(SweepTest):
    def test_that_comes_and_goes_before_the_lock_is_taken(self):
        words = ["sweep", "gas.toml", "--vary", "gas.seed=1,2", "--until", 0.1, "--quiet", "--out", "o"]
        self.succeed(*words)
        settings = self.read("o/sweep.json")
        self.path("o/sweep.json").unlink()
        os.mkfifo(self.path("o/sweep.json"))  # holds up the first look at it
        child = subprocess.Popen([CAROM, *map(str, words)], cwd=self.directory, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True)
        self.addCleanup(child.kill)
        with open(self.path("o/sweep.json"), "w", encoding="utf-8") as pipe:
            self.path("o/sweep.json").unlink()
            other = settings.replace('"replicas": 1', '"replicas": 2')
            self.assertNotEqual(other, settings)
            self.write("o/sweep.json", other)
            pipe.write(settings)
        errors = child.communicate(timeout=60)[1]
        self.assertEqual(child.returncode, 1, errors)
        self.assertIn("o: holds a sweep with other settings", errors)
        self.assertEqual(self.read("o/sweep.json"), other)


if __name__ == "__main__":
    main()
