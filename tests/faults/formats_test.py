"""Other programs read what carom writes: h5py finds H5MD 1.1 with the numbers bit for bit, ASE and OVITO's column names
fit the extended XYZ files; and what one format holds survives the way through another."""

import csv
import json
import unittest

import ase.io
import h5py
import numpy

from recovery import RecoveryTest


class H5mdTest(RecoveryTest):
    FORMAT = "h5md"

    def rows(self, name):
        return list(csv.DictReader(self.read(name).splitlines()))

    def test_layout_of_the_specification(self):
        with h5py.File(self.path("whole/trajectory.h5md"), "r") as file:
            self.assertEqual(list(file["h5md"].attrs["version"]), [1, 1])
            self.assertIn("name", file["h5md/author"].attrs)
            self.assertEqual(file["h5md/creator"].attrs["name"], b"carom")
            self.assertIn("version", file["h5md/creator"].attrs)
            particles = file["particles/all"]
            box = particles["box"]
            self.assertEqual(int(box.attrs["dimension"]), 2)
            self.assertEqual(list(box.attrs["boundary"]), [b"periodic", b"periodic"])
            self.assertEqual(box["edges"].shape, (2,))
            for name, shape in (("position", (13, 60, 2)), ("velocity", (13, 60, 2)), ("image", (13, 60, 2)),
                                ("id", (13, 60))):
                self.assertEqual(particles[name]["value"].shape, shape)
                self.assertEqual(particles[name]["step"].shape, (13,))
                numpy.testing.assert_array_equal(particles[name]["time"][:], numpy.arange(13) * 0.5)
            self.assertEqual(particles["position/value"].compression, "gzip")
            self.assertEqual(particles["position/value"].dtype, numpy.dtype("<f8"))
            for name in ("species", "mass", "radius"):
                self.assertEqual(particles[name].shape, (60,))
            numpy.testing.assert_array_equal(particles["id/value"][5], numpy.arange(60))
            energy = file["observables/kinetic_energy"]
            self.assertEqual(energy["value"].shape, energy["time"].shape)

    def test_numbers_are_those_of_the_run_bit_for_bit(self):
        self.succeed("run", "gas.toml", "--until", 6, "--every", 0.5, "--out", "text")
        self.succeed("convert", "text/trajectory.xyz", "text.csv")
        self.succeed("convert", "whole/trajectory.h5md", "whole.csv")
        text, binary = self.rows("text.csv"), self.rows("whole.csv")
        self.assertEqual(len(text), 13 * 60)
        for one, other in zip(text, binary, strict=True):
            for key in ("time", "id", "x", "y", "vx", "vy", "radius", "mass"):
                self.assertEqual(one[key], other[key])
        with h5py.File(self.path("whole/trajectory.h5md"), "r") as file:
            position = file["particles/all/position/value"][:]
            velocity = file["particles/all/velocity/value"][:]
            image = file["particles/all/image/value"][:]
        for k, row in enumerate(binary):
            frame, disk = divmod(k, 60)
            self.assertEqual([float(row["x"]), float(row["y"])], list(position[frame, disk]))
            self.assertEqual([float(row["vx"]), float(row["vy"])], list(velocity[frame, disk]))
            self.assertEqual([int(row["winding_x"]), int(row["winding_y"])], list(image[frame, disk]))
        self.assertGreater(numpy.abs(image).max(), 0, "nobody crossed a seam: the images say nothing")

    def test_images_unwrap_the_paths(self):
        with h5py.File(self.path("whole/trajectory.h5md"), "r") as file:
            edges = file["particles/all/box/edges"][:]
            path = file["particles/all/position/value"][:] + file["particles/all/image/value"][:] * edges
            fastest = numpy.abs(file["particles/all/velocity/value"][:]).max()
        self.assertLess(numpy.abs(numpy.diff(path, axis=0)).max(), 3 * fastest * 0.5)

    def test_there_and_back(self):
        self.succeed("convert", "whole/trajectory.h5md", "a.xyz")
        self.succeed("convert", "a.xyz", "b.h5md")
        self.succeed("convert", "b.h5md", "c.xyz")
        self.assertEqual(self.read("a.xyz"), self.read("c.xyz"))
        info = json.loads(self.succeed("info", "b.h5md", "--json").stdout)
        self.assertEqual((info["frames"], info["first_time"], info["last_time"], info["disks"]), (13, 0, 6, 60))


class XyzTest(RecoveryTest):
    def test_ase_reads_every_frame(self):
        frames = ase.io.read(self.path("whole/trajectory.xyz"), index=":", format="extxyz")
        self.assertEqual(len(frames), 13)
        self.succeed("convert", "whole/trajectory.xyz", "whole.csv")
        rows = list(csv.DictReader(self.read("whole.csv").splitlines()))
        for k, row in enumerate(rows):
            frame, disk = divmod(k, 60)
            self.assertEqual(frames[frame].positions[disk][0], float(row["x"]))
            self.assertEqual(frames[frame].positions[disk][1], float(row["y"]))
            self.assertEqual(frames[frame].arrays["velo"][disk][0], float(row["vx"]))
            self.assertEqual(frames[frame].info["Time"], float(row["time"]))
        self.assertEqual(list(frames[0].pbc), [True, True, False])

    def test_columns_have_ovitos_names(self):
        comment = self.read("whole/trajectory.xyz").splitlines()[1]
        self.assertIn("Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1", comment)
        for key in ("Lattice=", "pbc=", "Time="):
            self.assertIn(key, comment)


if __name__ == "__main__":
    unittest.main()
