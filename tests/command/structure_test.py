"""g(r), S(k) and ψ6 of a trajectory that carom wrote are those that NumPy and SciPy find in the same file."""

import csv
import re

import numpy
from scipy.spatial import Voronoi

from program import ProgramTest, main

K_MAX = 15.0


class Trajectory:
    """Frames of an extended XYZ file: positions in a periodic box."""

    def __init__(self, text):
        lines = text.splitlines()
        self.count = int(lines[0])
        cell = [float(x) for x in re.search(r'Lattice="([^"]*)"', lines[1])[1].split()]
        self.box = numpy.array([cell[0], cell[4]])
        step = self.count + 2
        self.frames = [numpy.array([[float(x) for x in line.split()[1:3]] for line in lines[k + 2:k + step]])
                       for k in range(0, len(lines), step)]

    def pairs(self, x):
        """Indices of all pairs, and their distances to the nearest image."""
        first, second = numpy.triu_indices(self.count, 1)
        r = x[second] - x[first]
        r -= self.box * numpy.rint(r / self.box)
        return first, second, numpy.hypot(r[:, 0], r[:, 1])

    def order(self, x):
        """ψ6 and number of Voronoi neighbours of each disk, with images all around the box."""
        shifts = sorted(((a, b) for a in (-1, 0, 1) for b in (-1, 0, 1)), key=lambda shift: shift != (0, 0))
        points = numpy.concatenate([x + self.box * shift for shift in shifts])
        psi, neighbours = numpy.zeros(self.count, complex), numpy.zeros(self.count)
        for ridge in Voronoi(points).ridge_points:
            for i, j in (ridge, ridge[::-1]):
                if i < self.count:
                    r = points[j] - points[i]
                    psi[i] += numpy.exp(6j * numpy.arctan2(r[1], r[0]))
                    neighbours[i] += 1
        return psi / neighbours, neighbours


class Structure(ProgramTest):
    def setUp(self):
        super().setUp()
        self.succeed("make", "gas", "--disks", 150, "--packing", 0.4, "--aspect", 1.3, "--start", "random",
                     "-o", "gas.toml")
        self.succeed("run", "gas.toml", "--until", 6, "--every", 1, "--trajectory", "xyz", "--out", "run", "--quiet")
        self.found = self.json_of("analyze", "run", "--what", "rdf,structure_factor,psi6", "--csv", "tables")
        self.trajectory = Trajectory(self.read("run/trajectory.xyz"))
        self.assertEqual(len(self.trajectory.frames), 7)

    def table(self, name):
        with open(self.path(f"tables/{name}.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return {key: numpy.array([float(row[key]) for row in rows]) for key in rows[0]}

    def estimate(self, observable, name):
        return next(entry["value"] for entry in self.found[observable] if entry["name"] == name)

    def test_pair_distribution(self):
        table = self.table("rdf")
        edges = numpy.arange(len(table["r"]) + 1) * (table["r"][1] - table["r"][0])
        counts = sum(numpy.histogram(self.trajectory.pairs(x)[2], edges)[0] for x in self.trajectory.frames)
        pairs = self.trajectory.count * (self.trajectory.count - 1) / 2 * len(self.trajectory.frames)
        ideal = numpy.pi * numpy.diff(edges**2) / self.trajectory.box.prod()
        numpy.testing.assert_allclose(table["g"], counts / pairs / ideal, rtol=1e-10)

    def test_structure_factor(self):
        table = self.table("structure_factor")
        unit = 2 * numpy.pi / self.trajectory.box
        largest = (K_MAX / unit).astype(int)
        n = numpy.array([(x, y) for x in range(-largest[0], largest[0] + 1) for y in range(largest[1] + 1)
                         if y > 0 or x > 0])
        waves = n * unit
        k = numpy.hypot(waves[:, 0], waves[:, 1])
        waves, k = waves[k <= K_MAX], k[k <= K_MAX]
        s = numpy.mean([abs(numpy.exp(1j * waves @ x.T).sum(axis=1))**2 / len(x) for x in self.trajectory.frames],
                       axis=0)
        shells = int(K_MAX / unit.max())
        shell = numpy.ceil(k / K_MAX * shells).astype(int) - 1
        vectors = numpy.bincount(shell)
        numpy.testing.assert_array_equal(table["vectors"], vectors)
        numpy.testing.assert_allclose(table["k"], numpy.bincount(shell, k) / vectors, rtol=1e-10)
        numpy.testing.assert_allclose(table["S"], numpy.bincount(shell, s) / vectors, rtol=1e-9)

    def test_bond_orientational_order(self):
        orders = [self.trajectory.order(x) for x in self.trajectory.frames]
        table = self.table("psi6")
        numpy.testing.assert_allclose(table["psi6"], [abs(psi.mean()) for psi, _ in orders], rtol=1e-9)
        numpy.testing.assert_allclose(table["psi6_local"], [abs(psi).mean() for psi, _ in orders], rtol=1e-9)
        for name, count in (("fivefold", 5), ("sixfold", 6), ("sevenfold", 7)):
            shares = [(neighbours == count).mean() for _, neighbours in orders]
            numpy.testing.assert_allclose(table[name], shares, rtol=1e-12)
            self.assertAlmostEqual(self.estimate("psi6", name), numpy.mean(shares), 12)

    def test_correlation_of_orientation(self):
        table = self.table("g6")
        width = min(numpy.diff(table["r"]))
        total, count = numpy.zeros(len(table["r"])), numpy.zeros(len(table["r"]))
        for x in self.trajectory.frames:
            psi = self.trajectory.order(x)[0]
            first, second, r = self.trajectory.pairs(x)
            correlation = (psi[first].conj() * psi[second]).real
            for row, centre in enumerate(table["r"]):
                here = abs(r - centre) < width / 2
                total[row] += correlation[here].sum()
                count[row] += here.sum()
        numpy.testing.assert_allclose(table["g6"], total / count, rtol=1e-9, atol=1e-12)


if __name__ == "__main__":
    main()
