"""Whatever `carom make` makes, `check` accepts, `run` runs, `info` describes and `draw` draws; `convert` keeps every
bit."""

import json
import math
import re
import struct
import tomllib
import unittest

from program import SCENES, TWO_DISKS, ProgramTest, main

MAKERS = {
    "gas": ["--disks", "60", "--packing", "0.5"],
    "two-disk": [],
    "cradle": [],
    "break": [],
    "galperin": ["--digits", "2"],
    "brownian": [],
}


class Make(ProgramTest):
    def test_list_names_every_maker(self):
        names = [line.split()[0] for line in self.succeed("make", "--list").stdout.splitlines()]
        self.assertEqual(sorted(names), sorted(MAKERS))

    def test_every_scene_can_be_checked_described_drawn_and_run(self):
        for name, options in MAKERS.items():
            with self.subTest(scene=name):
                done = self.succeed("make", name, *options, "-o", "scene.toml")
                self.assertEqual(done.stdout, "")
                self.assertTrue(done.stderr.startswith("carom: wrote scene.toml"))
                self.assertEqual(self.succeed("make", name, *options, "-o", "-").stdout, self.read("scene.toml"))
                self.assertIn("no problems", self.succeed("check", "scene.toml").stdout)
                info = self.json_of("info", "scene.toml")
                self.assertTrue(info["until"] or info["collisions"], "a scene says when it ends")
                self.succeed("draw", "scene.toml", "-o", "scene.svg")
                report = self.json_of("run", "scene.toml", "--until", "0.25")
                self.assertEqual(report["disks"], info["disks"])
                self.assertEqual(report["scene_digest"], info["scene_digest"])

    def test_scenes_of_the_repository_are_sound(self):
        scenes = sorted(SCENES.glob("*.toml"))
        self.assertGreaterEqual(len(scenes), 5)
        for scene in scenes:
            self.succeed("check", scene)

    def test_galperin(self):
        for digits, count in ((1, 3), (2, 31), (3, 314)):
            self.succeed("make", "galperin", "--digits", digits, "-o", "pi.toml")
            report = self.json_of("run", "pi.toml")
            self.assertEqual(report["collisions"] + report["wall_collisions"], count)

    def test_cradle_passes_the_pulse_on(self):
        self.succeed("make", "cradle", "--disks", 4, "-o", "cradle.toml")
        self.json_of("run", "cradle.toml", "--until", "6", "--out", "o")
        speeds = [float(row.split()[4]) for row in self.read("o/final.xyz").splitlines()[2:]]
        self.assertEqual(speeds, [0, 0, 0, 1])


class Gas(ProgramTest):
    def scene(self, *options, disks=80, packing=0.4):
        self.succeed("make", "gas", "--disks", disks, "--packing", packing, *options, "-o", "gas.toml")
        return tomllib.loads(self.read("gas.toml"))

    def info(self):
        return self.json_of("info", "gas.toml")

    def test_plain(self):
        self.scene()
        info = self.info()
        self.assertEqual(info["disks"], 80)
        self.assertAlmostEqual(info["packing_fraction"], 0.4, delta=1e-14)
        self.assertAlmostEqual(info["temperature"], 1, delta=1e-14)
        self.assertEqual(info["boundary"], ["periodic", "periodic"])
        self.assertAlmostEqual(info["box"][0], info["box"][1], delta=1e-12)
        self.assertLess(math.hypot(*info["momentum"]), 1e-12)

    def test_temperature(self):
        self.scene("--temperature", 2.5)
        self.assertAlmostEqual(self.info()["temperature"], 2.5, delta=1e-13)
        self.scene("--temperature", 0)
        self.assertEqual(self.info()["energy"], 0)

    def test_seed(self):
        digests = []
        for seed in (1, 2, 2, 18446744073709551615):
            self.scene("--seed", seed)
            digests.append(self.info()["scene_digest"])
        self.assertEqual(digests[1], digests[2])
        self.assertEqual(len(set(digests)), 3)

    def test_boundary(self):
        for boundary in ("periodic", "reflecting", "open"):
            self.scene("--boundary", boundary)
            self.assertEqual(self.info()["boundary"], [boundary, boundary])

    def test_two_kinds(self):
        self.scene("--radius-ratio", 1.4, "--mass-ratio", 3, "--fraction", 0.25)
        info = self.info()
        self.assertEqual(info["species"], [{"radius": 0.5, "mass": 1.0, "disks": 60},
                                           {"radius": 0.7, "mass": 3.0, "disks": 20}])
        self.assertAlmostEqual(info["packing_fraction"], 0.4, delta=1e-14)
        self.scene("--mass-ratio", 3)
        self.assertEqual([kind["disks"] for kind in self.info()["species"]], [40, 40])

    def test_aspect(self):
        self.scene("--aspect", 0.5)
        width, height = self.info()["box"]
        self.assertAlmostEqual(height / width, 0.5, delta=1e-14)

    def test_start(self):
        self.scene("--start", "lattice")
        lattice = self.info()["scene_digest"]
        self.scene("--start", "random")
        self.assertNotEqual(self.info()["scene_digest"], lattice)


class Info(ProgramTest):
    def test_text_and_json_agree(self):
        self.write("scene.toml", 'title = "Two"\n' + TWO_DISKS + "[run]\nuntil = 5.0\n")
        info = self.json_of("info", "scene.toml")
        text = self.succeed("info", "scene.toml").stdout
        for key, value in info.items():
            if key != "species" and isinstance(value, (int, float, str)):
                shown = value if isinstance(value, str) else json.dumps(value)
                self.assertRegex(text, rf"(?m)^{key} +{re.escape(shown)}$")
        self.assertEqual((info["title"], info["disks"], info["until"]), ("Two", 2, 5))
        self.assertEqual(info["box"], [10, 10])

    def test_trajectory(self):
        self.write("scene.toml", TWO_DISKS)
        self.succeed("run", "scene.toml", "--until", 2, "--every", 0.5, "--out", "o")
        self.assertEqual(self.json_of("info", "o/trajectory.xyz")["frames"], 5)

    def test_standard_input(self):
        self.assertEqual(self.json_of("info", "-", stdin=TWO_DISKS)["disks"], 2)


class Convert(ProgramTest):
    def test_round_trip_keeps_the_bits(self):
        for name, options in MAKERS.items():
            with self.subTest(scene=name):
                self.succeed("make", name, *options, "-o", "a.toml")
                for source, target in (("a.toml", "b.xyz"), ("b.xyz", "c.toml"), ("c.toml", "d.xyz")):
                    self.succeed("convert", source, target)
                self.assertEqual(self.read("b.xyz"), self.read("d.xyz"))
                digests = {self.json_of("info", file)["scene_digest"] for file in ("a.toml", "b.xyz", "c.toml", "d.xyz")}
                self.assertEqual(len(digests), 1)
                runs = {self.json_of("run", file, "--until", "0.5")["digest"] for file in ("a.toml", "b.xyz", "c.toml")}
                self.assertEqual(len(runs), 1)

    def test_algs4(self):
        self.write("one.txt", "1\n0.1 0.3 0.7 0.0 0.05 1.5 0 0 0\n")
        self.succeed("convert", "one.txt", "one.toml")
        (disk,) = tomllib.loads(self.read("one.toml"))["disk"]
        self.assertEqual(disk, {"position": [0.1, 0.3], "velocity": [0.7, 0.0], "radius": 0.05, "mass": 1.5})

    def test_in_place(self):
        self.write("scene.toml", TWO_DISKS)
        before = self.json_of("info", "scene.toml")["scene_digest"]
        self.succeed("convert", "scene.toml", "scene.toml")
        self.assertEqual(self.json_of("info", "scene.toml")["scene_digest"], before)


class Draw(ProgramTest):
    def setUp(self):
        super().setUp()
        if self.carom("draw", "--help").returncode != 0:
            raise unittest.SkipTest("built without pictures")
        self.write("scene.toml", 'title = "Two & more"\n' + TWO_DISKS)

    def test_formats(self):
        for name, start in (("a.svg", b"<?xml"), ("a.png", b"\x89PNG\r\n"), ("a.pdf", b"%PDF"), ("A.SVG", b"<?xml")):
            self.succeed("draw", "scene.toml", "-o", name)
            self.assertTrue(self.path(name).read_bytes().startswith(start))

    def test_width(self):
        self.succeed("draw", "scene.toml", "-o", "a.png", "--width", 300)
        width, height = struct.unpack(">II", self.path("a.png").read_bytes()[16:24])
        self.assertLessEqual(width, 300)
        self.assertGreater(height, 100)

    def test_time_and_options_change_the_picture(self):
        pictures = set()
        choices = ([], ["--time", "2"], ["--colour", "speed"], ["--color=species", "--velocities"], ["--title", "Other"])
        for options in choices:
            self.succeed("draw", "scene.toml", "-o", "a.svg", *options)
            pictures.add(self.read("a.svg"))
        self.assertEqual(len(pictures), len(choices))

    def test_same_input_same_bytes(self):
        self.succeed("draw", "scene.toml", "-o", "a.png")
        self.succeed("draw", "scene.toml", "-o", "b.png")
        self.assertEqual(self.path("a.png").read_bytes(), self.path("b.png").read_bytes())


if __name__ == "__main__":
    main()
