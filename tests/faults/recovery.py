"""What the tests of this folder share: a run that is stopped in the middle, and proof that nothing was lost."""

import json
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "command"))

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import CAROM, ProgramTest  # noqa: E402

COLUMNS = [f"particles/all/{name}/value" for name in ("position", "velocity", "image", "id")]
COLUMNS += ["observables/kinetic_energy/value", "observables/temperature/value", "particles/all/position/step",
            "particles/all/position/time"]


def frames_of(path):
    """The whole frames of an H5MD file, column by column: opened as any program would, without repair."""
    with h5py.File(path, "r") as file:
        count = min(file[name].shape[0] for name in COLUMNS)
        return {name: file[name][:count] for name in COLUMNS}


class RecoveryTest(ProgramTest):
    FORMAT = "xyz"

    def setUp(self):
        super().setUp()
        self.succeed("make", "gas", "--disks", 60, "--packing", 0.5, "-o", "gas.toml")
        done = self.run_in("whole")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.reference = done.report

    def words(self, out):
        return ["run", "gas.toml", "--until", 6, "--out", out, "--every", 0.5, "--trajectory", self.FORMAT,
                "--log-collisions", f"{out}/collisions.csv", "--checkpoint-every", 1, "--json", "--quiet",
                "--observe", "pressure,msd,vacf,speeds"]

    def run_in(self, out, *more, **variables):
        """The finished process of a run into `out`, with these environment variables."""
        done = self.carom(*self.words(out), *more, env={**os.environ, **variables})
        done.report = json.loads(done.stdout) if done.returncode == 0 else None
        return done

    def start(self, *words, variables=None):
        return subprocess.Popen([CAROM, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                cwd=self.directory, env={**os.environ, **(variables or {})})

    def has_checkpoint(self, out):
        return any(self.path(f"{out}/{name}").exists() for name in ("checkpoint.h5", "checkpoint-1.h5"))

    def assert_readable(self, out):
        """Every file that is there can be read, up to its last whole frame."""
        for name in ("checkpoint.h5", "checkpoint-1.h5"):
            if self.path(f"{out}/{name}").exists():
                self.succeed("info", f"{out}/{name}")
        trajectory = self.path(f"{out}/trajectory.{self.FORMAT}")
        if not trajectory.exists() or trajectory.stat().st_size == 0:
            return
        if self.FORMAT == "h5md":
            for name, values in frames_of(trajectory).items():
                whole = frames_of(self.path(f"whole/trajectory.h5md"))[name]
                numpy.testing.assert_array_equal(values, whole[:len(values)])
        done = self.carom("info", f"{out}/trajectory.{self.FORMAT}")
        if done.returncode != 0 and self.FORMAT == "xyz":  # not one whole frame yet
            whole = self.path("whole/trajectory.xyz").stat().st_size
            self.assertLess(trajectory.stat().st_size, whole / 12)
        else:
            self.assertTrue(done.returncode == 0 or "there is no frame" in done.stderr, done)

    def assert_resumes_to_the_same(self, out, *more):
        """Going on from what is there leads to the files of the run that was never stopped."""
        done = self.succeed("resume", out, "--json", "--quiet", *more)
        report = json.loads(done.stdout)
        for key in ("digest", "scene_digest", "collisions", "pressure", "energy_drift", "max_overlap", "ties",
                    "observables"):
            self.assertEqual(report[key], self.reference[key], key)
        self.assert_same_files(out)

    def assert_same_files(self, out):
        for name in ("final.xyz", "collisions.csv", "scene.toml"):
            self.assertEqual(self.path(f"{out}/{name}").read_bytes(), self.path(f"whole/{name}").read_bytes(), name)
        tables = sorted(path.name for path in self.path("whole/observables").iterdir())
        self.assertGreater(len(tables), 3)
        for name in tables:
            self.assertEqual(self.read(f"{out}/observables/{name}"), self.read(f"whole/observables/{name}"), name)
        if self.FORMAT == "xyz":
            self.assertEqual(self.path(f"{out}/trajectory.xyz").read_bytes(),
                             self.path("whole/trajectory.xyz").read_bytes())
            return
        found, whole = (frames_of(self.path(f"{name}/trajectory.h5md")) for name in (out, "whole"))
        for name in COLUMNS:
            numpy.testing.assert_array_equal(found[name], whole[name])
        leftover = [path.name for path in self.path(out).iterdir() if ".new-" in path.name]
        self.assertEqual(leftover, [])
