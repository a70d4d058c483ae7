"""`carom run --observe` and `carom analyze` find what their files and reports say, change no digest, and refuse names and
options that there are not, with the place and the nearest known name."""

import csv
import json
import math

from program import TWO_DISKS, ProgramTest, main

GAS = """
[[gas]]
count = 100
packing_fraction = 0.3

[run]
collisions = 2000
"""


class ObserveTest(ProgramTest):
    def table(self, name):
        """Columns of a CSV file by name."""
        with open(self.path(name), newline="") as file:
            rows = list(csv.reader(file))
        return {name: [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}

    def observables(self, *words):
        return self.json_of("run", *words)["observables"]

    def estimate(self, observables, observable, name):
        (found,) = [each for each in observables[observable] if each["name"] == name]
        return found


class Run(ObserveTest):
    def setUp(self):
        super().setUp()
        self.write("gas.toml", GAS)

    def test_estimates_stand_in_the_report(self):
        observables = self.observables("gas.toml", "--observe", "pressure,rate", "--collisions", 20000)
        self.assertEqual(list(observables), ["pressure", "rate"])
        z = self.estimate(observables, "pressure", "Z")
        self.assertEqual(set(z), {"name", "value", "error", "unit", "samples", "blocks", "correlation_time", "theory",
                                  "theory_source", "warnings"})
        self.assertAlmostEqual(z["value"], z["theory"], delta=5 * z["error"] + 0.02)
        self.assertAlmostEqual(z["theory"], 2.06326 * (1 - 0.375 / 100), delta=1e-5)
        self.assertGreater(z["samples"], 10)
        rate = self.estimate(observables, "rate", "collision_rate")
        self.assertAlmostEqual(rate["value"] / rate["theory"], 1, delta=0.05)

    def test_without_observables_the_report_has_none(self):
        self.assertEqual(self.observables("gas.toml"), {})
        self.assertNotIn("Observables", self.succeed("run", "gas.toml").stdout)

    def test_short_runs_are_warned_of(self):
        z = self.estimate(self.observables("gas.toml", "--observe", "pressure"), "pressure", "Z")
        self.assertEqual(z["blocks"], 0)
        self.assertIn("too short", z["warnings"][0])
        self.assertIn("warning: the run is too short", self.succeed("run", "gas.toml", "--observe", "pressure").stdout)

    def test_text_shows_errors_in_brackets(self):
        text = self.succeed("run", "gas.toml", "--observe", "pressure").stdout
        self.assertRegex(text, r"\n  pressure +Z = 2\.\d+\(\d+\), theory 2\.0555\d \(Kolafa and Rottner 2006, at this N\)")

    def test_digests_do_not_change(self):
        plain = self.json_of("run", "gas.toml")
        observed = self.json_of("run", "gas.toml", "--observe", "pressure,rate,speeds,msd,vacf,temperature_profile")
        for key in ("digest", "collisions", "pressure", "windows"):
            self.assertEqual(observed[key], plain[key])

    def test_the_same_numbers_for_any_patches_and_solver(self):
        words = ("gas.toml", "--observe", "pressure,rate,speeds,msd,vacf,pressure_tensor")
        expected = self.observables(*words)
        self.assertEqual(self.observables(*words, "--patches", "3x2", "--threads", 2), expected)
        self.assertEqual(self.observables(*words, "--solver", "reference"), expected)

    def test_sections_of_the_scene_and_their_options(self):
        self.write("gas.toml", GAS + '[[observe]]\nname = "temperature_profile"\nbins = 3\n[[observe]]\nname = "rate"\n')
        self.assertEqual(list(self.observables("gas.toml", "--out", "out")), ["temperature_profile", "rate"])
        self.assertEqual(len(self.table("out/observables/temperature_profile_x.csv")["x"]), 3)
        # The scene as run says so, too; the option of the command line takes the place of the sections.
        self.assertEqual(list(self.observables("out/scene.toml")), ["temperature_profile", "rate"])
        self.assertEqual(list(self.observables("gas.toml", "--observe", "speeds")), ["speeds"])

    def test_equilibrate_starts_them(self):
        everything = self.estimate(self.observables("gas.toml", "--observe", "rate"), "rate", "collision_rate")
        later = self.estimate(self.observables("gas.toml", "--observe", "rate", "--equilibrate", 8), "rate",
                              "collision_rate")
        self.assertLess(later["samples"], everything["samples"])

    def test_files_and_their_index(self):
        report = self.json_of("run", "gas.toml", "--observe", "speeds,vacf,rate", "--out", "out")
        index = json.loads(self.read("out/observables/index.json"))["observables"]
        self.assertEqual([each["name"] for each in index], ["speeds", "vacf", "rate"])
        self.assertEqual(index[2]["estimates"], report["observables"]["rate"])
        self.assertEqual(json.loads(self.read("out/report.json"))["observables"], report["observables"])
        for each in index:
            for table in each["tables"]:
                columns = self.table("out/observables/" + table["file"])
                self.assertEqual(list(columns), [column["name"] for column in table["columns"]])
                self.assertGreater(len(columns[table["columns"][0]["name"]]), 1)
                self.assertEqual({"name", "file", "title", "logarithmic_x", "logarithmic_y", "bars", "columns"}, set(table))
        speeds = self.table("out/observables/speeds.csv")
        self.assertAlmostEqual(sum(speeds["f"]) * 0.1, 1, delta=1e-9)

    def test_overwriting_removes_the_files_of_the_run_before(self):
        self.succeed("run", "gas.toml", "--observe", "vacf", "--out", "out")
        self.refuse(["run", "gas.toml", "--out", "out"], 1, "holds a run already")
        self.succeed("run", "gas.toml", "--observe", "rate", "--out", "out", "--overwrite")
        self.assertFalse(self.path("out/observables/vacf.csv").exists())
        self.path("out/observables/mine.txt").write_text("keep me")
        self.succeed("run", "gas.toml", "--out", "out", "--overwrite")
        self.assertEqual([path.name for path in self.path("out/observables").iterdir()], ["mine.txt"])


class Refusals(ObserveTest):
    def test_names_on_the_command_line(self):
        self.write("gas.toml", GAS)
        self.refuse(["run", "gas.toml", "--observe", "presure"], 2, "--observe", "'presure'", "did you mean 'pressure'?")
        self.refuse(["run", "gas.toml", "--observe", "rate,rate"], 2, "twice")
        self.refuse(["run", "gas.toml", "--observe", ""], 2, "--observe")
        self.refuse(["analyze", "a.xyz", "--what", "msdd"], 2, "did you mean 'msd'?")

    def test_sections_of_a_scene(self):
        for section, place, *parts in (
                ('[[observe]]\nname = "speds"\n', "bad.toml:9:1", "did you mean 'speeds'?"),
                ('[[observe]]\nname = "msd"\nlevel = 3\n', "bad.toml:11:1", "'level' of msd", "did you mean 'levels'?"),
                ('[[observe]]\nname = "msd"\nlevels = 3.5\n', "bad.toml:11:1", "a whole number from 1 to 40"),
                ('[[observe]]\nname = "msd"\ninterval = 0\n', "bad.toml:11:1", "interval of msd is 0"),
                ('[[observe]]\nname = "msd"\nlevels = "7"\n', "bad.toml:11:10", "levels must be a number"),
                ('[[observe]]\nlevels = 7\n', "bad.toml:9:1", "needs a name"),
                ('[[observe]]\nname = 7\n', "bad.toml:10:8", "name must be a string"),
                ('[observe]\nname = "msd"\n', "bad.toml", "[[observe]]"),
                ('[[observe]]\nname = "wall_pressure"\n', "bad.toml:9:1", "the box has no walls")):
            with self.subTest(section=section):
                self.write("bad.toml", GAS + "\n" + section)
                self.refuse(["run", "bad.toml"], 1, place, *parts)

    def test_check_finds_them_too_and_all_at_once(self):
        self.write("bad.toml", GAS + '\n[[observe]]\nname = "speds"\n[[observe]]\nname = "msd"\nbins = 3\n'
                                     '[[disk]]\nposition = [1.0, 1.0]\nradius = -1.0\n')
        self.refuse(["check", "bad.toml"], 1, "bad.toml:9:1", "'speds'", "bad.toml:13:1", "'bins'", "radius is -1")

    def test_nothing_is_written_for_what_cannot_be_observed(self):
        self.write("gas.toml", GAS)
        self.refuse(["run", "gas.toml", "--observe", "wall_pressure", "--out", "out"], 1, "the box has no walls")
        self.assertFalse(self.path("out/scene.toml").exists())


class Analyze(ObserveTest):
    def save(self, every=0.0625, *more):
        self.write("gas.toml", GAS)
        self.succeed("run", "gas.toml", "--until", 8, "--every", every, "--out", "out", *more)

    def test_finds_what_the_run_found(self):
        self.save()
        self.succeed("analyze", "out", "--what", "msd,vacf", "--csv", "again")
        # The same frames, but for the last ones: a run measures whole windows.
        self.write("gas.toml", GAS + '[[observe]]\nname = "msd"\ninterval = 0.0625\n')
        self.succeed("run", "gas.toml", "--until", 8, "--out", "run")
        found, expected = self.table("again/msd.csv"), self.table("run/observables/msd.csv")
        self.assertGreater(len(expected["msd"]), 20)
        for t, a, b in zip(expected["time"], found["msd"], expected["msd"]):
            self.assertAlmostEqual(a / b, 1, delta=0.03 + 0.1 * t)

    def test_displacements_by_a_direct_computation(self):
        self.save(0.25)
        frames = self.frames("out/trajectory.xyz")
        size = math.sqrt(100 * math.pi / 4 / 0.3)
        path = [frames[0]]  # not folded into the box
        for before, now in zip(frames, frames[1:]):
            path.append([[at + (y - x) - size * round((y - x) / size) for at, x, y in zip(*disk)]
                         for disk in zip(path[-1], before, now)])
        found = self.table_of_analysis()
        for lag in (1, 2, 7):
            squares = [sum((b - a) ** 2 for a, b in zip(disk, other))
                       for start in range(len(path) - lag)
                       for disk, other in zip(path[start], path[start + lag])]
            self.assertAlmostEqual(found["msd"][lag - 1], sum(squares) / len(squares), delta=1e-9)

    def frames(self, name):
        """Per frame the x and y of every disk."""
        lines = self.read(name).splitlines()
        count = int(lines[0])
        frames = [lines[k + 2:k + 2 + count] for k in range(0, len(lines), count + 2)]
        return [[[float(word) for word in line.split()[1:3]] for line in frame] for frame in frames]

    def table_of_analysis(self):
        self.succeed("analyze", "out/trajectory.xyz", "--what", "msd", "--csv", "tables")
        return self.table("tables/msd.csv")

    def test_everything_that_frames_tell_by_default(self):
        self.save()
        found = self.json_of("analyze", "out")
        self.assertTrue({"msd", "speeds", "temperature", "temperature_profile", "vacf"} <= set(found))
        self.assertFalse({"pressure", "rate"} & set(found))
        self.assertAlmostEqual(self.estimate(found, "temperature", "kT")["value"], 1, delta=1e-9)
        self.assertIn("Observables\n", self.succeed("analyze", "out").stdout)

    def test_by_default_only_what_the_frames_have(self):
        self.write("open.toml", GAS.replace("[run]", '[box]\nboundary = "open"\n[run]').replace("2000", "100"))
        self.succeed("run", "open.toml", "--out", "out")
        self.assertNotIn("temperature_profile", self.json_of("analyze", "out/final.xyz"))
        self.refuse(["analyze", "out/final.xyz", "--what", "temperature_profile"], 1, "the plane is open")

    def test_what_needs_collisions_is_refused_in_one_line(self):
        self.save()
        for name in ("pressure", "rate", "pressure_tensor", "wall_pressure"):
            done = self.refuse(["analyze", "out", "--what", name], 1, name, "cannot be had from frames")
            self.assertEqual(len(done.stderr.splitlines()), 1)

    def test_frames_too_far_apart_to_follow_disks(self):
        self.save(8)
        found = self.json_of("analyze", "out", "--what", "msd")
        self.assertIn("half a box", " ".join(found["msd"][0]["warnings"]))

    def test_files_that_are_no_trajectory(self):
        self.save(4)
        text = self.read("out/trajectory.xyz")
        frame = "".join(text.splitlines(keepends=True)[:102])
        self.write("again.xyz", frame + frame)
        self.write("other.xyz", frame + "1\n" + frame.splitlines()[1].replace("Time=0", "Time=1") + "\n"
                   + frame.splitlines()[2] + "\n")
        self.write("empty.xyz", "")
        self.path("bare").mkdir()
        for name, *parts in (("again.xyz", "frame 2", "not after"),
                             ("other.xyz", "frame 2", "1 disks"), ("empty.xyz", "empty.xyz"),
                             ("nowhere.xyz", "No such file"), ("bare", "holds no trajectory")):
            with self.subTest(name=name):
                done = self.refuse(["analyze", name, "--what", "msd"], 1, *parts)
                self.assertEqual(len(done.stderr.splitlines()), 1)

    def test_a_file_that_ends_in_the_middle_of_a_frame(self):
        self.save(4)
        self.write("cut.xyz", self.read("out/trajectory.xyz")[:-200])
        found = self.json_of("analyze", "cut.xyz", "--what", "speeds")
        self.assertIn("middle of a frame", " ".join(found["speeds"][0]["warnings"]))

    def test_a_single_frame(self):
        self.save()
        found = self.json_of("analyze", "out/final.xyz", "--what", "speeds,temperature,msd")
        self.assertAlmostEqual(self.estimate(found, "temperature", "kT")["value"], 1, delta=1e-9)
        self.assertIsNone(self.estimate(found, "msd", "diffusion")["value"])

    def test_frames_of_uneven_spacing(self):
        self.save(2)
        lines = self.read("out/trajectory.xyz").splitlines(keepends=True)
        self.write("uneven.xyz", "".join(lines[:204] + lines[306:]))
        self.refuse(["analyze", "uneven.xyz", "--what", "msd"], 1, "evenly spaced")
        self.succeed("analyze", "uneven.xyz", "--what", "temperature,speeds")


if __name__ == "__main__":
    main()
