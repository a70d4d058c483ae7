"""Bad input ends with exit code 1 (2 where the command line itself is at fault) and clear lines on stderr that name the
file with line and column, the thing and the reason; stdout stays empty, and no file that was there is lost."""

import os
import pathlib
import re
import resource
import subprocess
import tempfile

from program import CAROM, HAS_HDF5, SCENES, TWO_DISKS, ProgramTest, main

BOX = '[box]\nsize = [10.0, 10.0]\nboundary = "reflecting"\n'
COMMANDS = (["run", "--until", "1"], ["check"], ["info"], ["convert", "OUT.toml"], ["draw", "-o", "OUT.svg"])


def become_nobody():
    """In the child process: root may read and write anything, others are kept out as they are."""
    if os.geteuid() == 0:
        os.setuid(65534)


def disk(x, y, more=""):
    return f"[[disk]]\nposition = [{x}, {y}]\n{more}\n"


class BadInputTest(ProgramTest):
    def refuse_scene(self, name, *parts, lines=None):
        """Every command that reads a scene refuses this one with the same words."""
        said = set()
        for command, *rest in COMMANDS:
            words = [command, *(rest if command == "draw" else []), name, *(rest if command != "draw" else [])]
            with self.subTest(command=command):
                done = self.refuse(words, 1, *parts)
                said.add(done.stderr)
                if lines is not None and command == "check":
                    self.assertEqual(len(done.stderr.splitlines()), lines, done.stderr)
        self.assertEqual([p.name for p in self.directory.glob("OUT*")], [])
        return said

    def refuse_text(self, text, *parts, lines=None, name="scene.toml"):
        self.write(name, text)
        return self.refuse_scene(name, *parts, lines=lines)


class Unreadable(BadInputTest):
    def test_missing(self):
        self.refuse_scene("nowhere.toml", "nowhere.toml: ", "No such file", lines=1)

    def test_directory(self):
        self.path("folder.toml").mkdir()
        self.refuse_scene("folder.toml", "folder.toml: ", "directory", lines=1)

    def test_empty(self):
        for text in ("", "  \n\n\t\n"):
            self.refuse_text(text, "scene.toml: ", "empty", lines=1)

    def test_no_permission(self):
        self.write("scene.toml", TWO_DISKS)
        self.path("scene.toml").chmod(0)
        self.directory.chmod(0o755)
        for words in (["run", "scene.toml", "--until", "1"], ["check", "scene.toml"]):
            self.refuse(words, 1, "scene.toml: ", "Permission denied", preexec_fn=become_nobody)

    def test_binary(self):
        noise = bytes((37 * k * k + k) % 256 for k in range(4000))
        for name in ("scene.toml", "scene", "scene.xyz", "scene.txt"):
            self.refuse_text(noise, name, name=name, lines=1)
            self.refuse_text(noise.replace(b"\0", b""), name, name=name, lines=1)
        self.refuse_text(b"\x89HDF\r\n\x1a\n" + noise, "scene.toml", "HDF5", lines=1)

    def test_standard_input(self):
        for words in (["run", "-", "--until", "1"], ["check", "-"], ["info", "-"]):
            self.refuse(words, 1, "<stdin>: ", "empty")
            self.refuse(words, 1, "<stdin>:1:", stdin="nonsense\n")

    def test_closed_standard_input(self):
        done = subprocess.run(["/bin/sh", "-c", '"$0" check - <&-', CAROM], capture_output=True, text=True)
        self.assert_refused(done, 1, "<stdin>", "cannot be read")


class Toml(BadInputTest):
    def test_truncated_anywhere(self):
        text = (SCENES / "cradle.toml").read_text()
        for end in range(1, len(text), 37):
            self.write("scene.toml", text[:end])
            done = self.carom("check", "scene.toml")
            if done.returncode != 0:
                self.assert_refused(done, 1, "scene.toml")

    def test_not_toml(self):
        self.refuse_text(BOX + "[[disk]\n", "scene.toml:4:", "TOML", lines=1)
        self.refuse_text("disk = [[[[\n", "scene.toml:", "TOML", lines=1)
        self.refuse_text("a = " + "[" * 100_000, "scene.toml:", "TOML", lines=1)

    def test_unknown_keys_name_the_nearest_known_one(self):
        self.refuse_text(BOX + disk(1, 1, "raduis = 0.5"), "scene.toml:6:1: ", "'raduis'", "'radius'", lines=1)
        self.refuse_text(BOX.replace("boundary", "bundary") + disk(1, 1), "scene.toml:3:1: ", "'bundary'", "'boundary'")
        self.refuse_text(BOX + disk(1, 1) + "[physic]\nrestitution = 1.0\n", "'physic'", "'physics'", lines=1)
        self.refuse_text(BOX + disk(1, 1, "colour = 3"), "'colour'", "position", "velocity", "mass", lines=1)

    def test_wrong_types(self):
        for more, part in (('mass = "heavy"', "mass must be a number"), ("mass = [1.0]", "mass must be a number"),
                           ("velocity = 3.0", "two numbers"), ("velocity = [1.0]", "two numbers"),
                           ("velocity = [1.0, true]", "two numbers"), ("radius = false", "radius must be")):
            self.refuse_text(BOX + disk(1, 1, more), "scene.toml:6:", part, lines=1)
        self.refuse_text(BOX.replace('"reflecting"', '"round"') + disk(1, 1), "scene.toml:3:12: ", "round", "periodic")
        self.refuse_text(BOX.replace("[10.0, 10.0]", "10.0") + disk(1, 1), "scene.toml:2:8: ", "two numbers")
        self.refuse_text("box = 3\n" + disk(1, 1), "scene.toml:1:", "[box]")
        self.refuse_text(BOX + "[disk]\nposition = [1.0, 1.0]\n", "scene.toml:4:", "[[disk]]")
        self.refuse_text(BOX + "[[gas]]\ncount = 1e3\n", "scene.toml:5:9: ", "whole number")
        self.refuse_text(BOX + "[[gas]]\ncount = -5\n", "scene.toml:5:9: ", "count is -5")

    def test_numbers_that_are_none(self):
        for number in ("nan", "inf", "-inf", "+nan"):
            self.refuse_text(BOX + disk(1, number), "scene.toml:5:16: ", "finite", lines=1)
        self.refuse_text(BOX + disk(1, "1e400"), "scene.toml:5:", "1e400", lines=1)
        self.refuse_text(BOX + disk(1, "1e300"), "scene.toml:", "too large")
        self.refuse_text(BOX + disk(1, 1, "radius = 1e-300"), "scene.toml:", "too small")

    def test_radius_mass_and_time_must_be_positive(self):
        for value in ("0.0", "-1.0"):
            for name in ("radius", "mass"):
                self.refuse_text(BOX + disk(1, 1, f"{name} = {value}"), "scene.toml:6:", f"{name} is", "greater than 0",
                                 lines=1)
            self.refuse_text(BOX + disk(1, 1) + f"[run]\nuntil = {value}\n", "scene.toml:8:9: ", "until is", lines=1)
        self.refuse_text(BOX + disk(1, 1) + "[run]\ncollisions = 0\n", "scene.toml:8:14: ", "collisions is 0")
        self.refuse_text(BOX + disk(1, 1) + "[physics]\nrestitution = 1.5\n", "scene.toml:8:15: ", "[0, 1]")

    def test_all_problems_in_one_go(self):
        said = self.refuse_text(
            BOX + disk(1, 1, "raduis = 0.5") + disk(2, "nan", 'mass = "x"') + disk(5, 5, "radius = -1.0")
            + "[physics]\nrestitution = 2.0\n[run]\nuntil = 0.0\n",
            ":6:", ":8:", ":9:", ":12:", ":14:", ":16:", lines=6)
        self.assertEqual(len(said), 1, "all commands say the same")


class Scenes(BadInputTest):
    def test_overlap_names_both_and_how_much(self):
        self.refuse_text(BOX + disk(1, 1) + disk(5, 5) + disk(5.75, 5), "scene.toml:10:1: ", "disk 1 and disk 2",
                         "overlap by 0.25", lines=1)

    def test_overlap_across_a_periodic_edge(self):
        self.refuse_text('[box]\nsize = [10.0, 10.0]\n' + disk(0.25, 5) + disk(9.75, 5), "disk 0 and disk 1",
                         "overlap by 0.5")

    def test_coincident_centres(self):
        self.refuse_text(BOX + disk(5, 5) + disk(5, 5), "scene.toml:", "disk 0 and disk 1", "same centre", lines=1)

    def test_outside(self):
        self.refuse_text(BOX + disk(0.25, 5), "scene.toml:4:", "disk 0", "outside", "left wall", lines=1)
        self.refuse_text(BOX + disk(5, 12), "scene.toml:4:", "disk 0", "outside", "top wall", lines=1)

    def test_every_problem_of_a_scene_is_listed(self):
        self.refuse_text(BOX + disk(0.25, 5) + disk(5, 5) + disk(5.5, 5) + disk(5, 12), "disk 0", "disk 1 and disk 2",
                         "disk 3", lines=3)

    def test_narrow_periodic_box(self):
        self.refuse_text("[box]\nsize = [0.9, 10.0]\n" + disk(0.5, 5), "scene.toml:2:", "narrower", lines=1)

    def test_no_disks(self):
        self.refuse_text(BOX, "scene.toml: ", "no disks", lines=1)
        self.refuse_text(BOX + "[[gas]]\ncount = 0\n", "scene.toml:5:9: ", "count is 0", lines=1)

    def test_gases_that_cannot_fit(self):
        self.refuse_text(BOX + "[[gas]]\ncount = 60\n[[gas]]\ncount = 60\n", "scene.toml:4:", "do not fit", lines=1)

    def test_counts_beyond_this_machine(self):
        for count, where in ((10**18, "scene.toml:1:"), (3_900_000_000, "scene.toml:1:")):
            self.refuse_text(f"[[gas]]\ncount = {count}\npacking_fraction = 0.5\n", where, lines=1)

    def test_gas_without_a_size(self):
        self.refuse_text("[[gas]]\nradius = 0.5\n", "scene.toml:1:", "count")


class Packing(BadInputTest):
    def test_more_than_the_plane_holds_is_refused_at_once(self):
        self.refuse(["make", "gas", "--disks", "10000000", "--packing", "1.5", "-o", "OUT.toml"], 1, "0.9069")

    def can_be_placed(self, *words):
        done = self.refuse(["make", "gas", "--disks", *words, "-o", "OUT.toml"], 1, "can be placed")
        self.assertFalse(self.path("OUT.toml").exists())
        return re.search(r"up to ([0-9.]+) can be placed", done.stderr).group(1)

    def test_what_can_be_placed_is_said_and_can_be_placed(self):
        for count in ("4", "100", "997"):
            for boundary in ("periodic", "reflecting"):
                for packing in ("0.93", "1.5"):
                    with self.subTest(count=count, boundary=boundary, packing=packing):
                        most = self.can_be_placed(count, "--boundary", boundary, "--packing", packing)
                        self.succeed("make", "gas", "--disks", count, "--packing", most, "--boundary", boundary,
                                     "-o", "most.toml")
                        self.succeed("check", "most.toml")

    def test_in_a_box_of_given_size(self):
        self.write("scene.toml", BOX + "[[gas]]\ncount = 120\n")
        done = self.refuse(["check", "scene.toml"], 1, "scene.toml:4:", "can be placed")
        most = int(re.search(r"(\d+) can be placed", done.stderr).group(1))
        self.assertGreater(most, 80)
        self.write("scene.toml", BOX + f"[[gas]]\ncount = {most}\n")
        self.succeed("check", "scene.toml")

    def test_random_start_says_how_far_it_came(self):
        self.refuse(["make", "gas", "--disks", "200", "--packing", "0.7", "--start", "random", "-o", "OUT.toml"], 1,
                    "of 200 disks", "lattice")


class OtherFormats(BadInputTest):
    ROW = "0.5 0.5 0.1 0.0 0.05 1.0 0 0 0\n"

    def test_algs4(self):
        for text, *parts in (
                ("2\n" + self.ROW, ":2: ", "1 of 2"), ("1\n" + self.ROW + "junk\n", ":3:1: ", "after the last"),
                ("1\n" + self.ROW + self.ROW, ":3:1: "), ("1\n0.5 0.5 0.1\n", ":2:1: ", "3 columns"),
                ("1\n" + self.ROW.replace("0.05", "-1"), ":2:17: ", "radius is -1"),
                ("1\n" + self.ROW.replace("0.1", "x"), ":2:9: ", "'x'"),
                ("1\n" + self.ROW.replace("0.1", "nan"), ":2:9: ", "finite"), ("0\n", ":1:1: ", "number of disks is 0"),
                ("2\n" + self.ROW + self.ROW, ":3:1: ", "same centre")):
            self.refuse_text(text, "scene.txt", *parts, name="scene.txt", lines=1)

    def test_extended_xyz(self):
        head = 'Lattice="10 0 0 0 10 0 0 0 1" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1 pbc="T T F"\n'
        row = "A 5 5 0 1 0 0 0.5\n"
        for text, *parts in (
                ("2\n" + head + row, "1 of 2"), ("1\n", ":1: ", "comment"),
                ("1\nLattice=\"10 0 0 0 10 0 0 0 1\"\n" + row, ":2:", "Properties"),
                ("1\n" + head + row.replace("0.5", "big"), ":3:15: ", "'big'"),
                ("1\n" + head + "A 5 5 0 1\n", ":3:1: ", "columns")):
            self.refuse_text(text, "scene.xyz", *parts, name="scene.xyz", lines=1)
        self.write("scene.xyz", "2\n" + head + row + row)
        self.refuse(["check", "scene.xyz"], 1, "scene.xyz:4:1: ", "same centre")
        self.write("scene.xyz", "1\n" + head + row.replace("0.5", "0"))
        self.refuse(["check", "scene.xyz"], 1, "scene.xyz:3:1: ", "radius")


class Commands(BadInputTest):
    def test_make(self):
        for words, code, part in (
                (["gas", "--disks", "0", "--packing", "0.5"], 1, "0"), (["gas", "--disks", "10"], 2, "--packing"),
                (["gas", "--disks", "10", "--packing", "-1"], 1, "packing"),
                (["gas", "--disks", "10", "--packing", "0"], 1, "packing"),
                (["gas", "--disks", "ten", "--packing", "0.5"], 2, "'ten'"),
                (["gas", "--disks", "10.5", "--packing", "0.5"], 2, "'10.5'"),
                (["gas", "--disks", "4000000000", "--packing", "0.5"], 1, "too many"),
                (["gas", "--disks", "18446744073709551615", "--packing", "0.5"], 1, "too many"),
                (["gas", "--disks", "10", "--packing", "0.5", "--temperature", "-1"], 1, "temperature"),
                (["gas", "--disks", "10", "--packing", "0.5", "--boundary", "0"], 2, "periodic"),
                (["gas", "--disks", "10", "--packing", "0.5", "--fraction", "2"], 1, "fraction"),
                (["gas", "--disks", "10", "--packing", "0.5", "--aspect", "0"], 1, "aspect"),
                (["gas", "--disks", "10", "--packing", "0.5", "--radius-ratio", "inf"], 2, "--radius-ratio"),
                (["galperin", "--digits", "0"], 1, "digits"), (["galperin", "--digits", "8"], 1, "digits"),
                (["galperin", "--digits", "-1"], 2, "--digits"), (["galperin", "--digits", "99999999999"], 1, "digits"),
                (["cradle", "--disks", "1"], 1, "cradle"), (["cradle", "--disks", "4000000000"], 1, "memory")):
            with self.subTest(words=words):
                done = self.refuse(["make", *words, "-o", "OUT.toml"], code, part)
                self.assertEqual(len(done.stderr.splitlines()), 1)
                self.assertFalse(self.path("OUT.toml").exists())
        self.refuse(["make", "gas", "--disks", "10", "--packing", "0.5"], 2, "--output")
        self.refuse(["make", "gas", "--disks", "10", "--packing", "0.5", "-o", ""], 2, "-o")

    def test_what_is_no_command(self):
        self.refuse([], 2, "command")
        self.refuse(["rum"], 2, "no command 'rum'")
        self.refuse(["--verison"], 2, "no option '--verison'")
        self.refuse(["check", "--frob", "3", "scene.toml"], 2, "no option '--frob'", "carom check --help")
        self.refuse(["make", "gas", "--disc", "3", "-o", "a"], 2, "--")
        self.refuse(["make"], 2, "--list")
        self.refuse(["make", "nothing"], 2, "nothing")
        self.refuse(["check"], 2, "SCENE")
        self.refuse(["convert", "a.toml"], 2, "OUT")

    def test_endings(self):
        self.refuse(["convert", SCENES / "gas.toml", "OUT.gsd"], 1, "OUT.gsd", ".xyz")
        self.refuse(["convert", SCENES / "gas.toml", "OUT"], 1, "OUT", ".toml")
        self.refuse(["draw", SCENES / "gas.toml", "-o", "OUT.bmp"], 1, "OUT.bmp", ".png")
        for more in (["--time", "-1"], ["--width", "0"], ["--width", "1e9"]):
            self.refuse(["draw", SCENES / "gas.toml", "-o", "OUT.svg", *more], 1)
        self.assertEqual(list(self.directory.iterdir()), [])


WRITERS = {
    "final.xyz": ["run", "scene.toml", "--until", "1", "--out", "{}"],
    "made.toml": ["make", "cradle", "--disks", "500", "-o", "{}/made.toml"],
    "converted.xyz": ["convert", "gas.toml", "{}/converted.xyz"],
    "drawn.svg": ["draw", "gas.toml", "-o", "{}/drawn.svg"],
    "collision.svg": ["collide", "--disk", "0,0,1,0", "--disk", "1,0,0,0", "--svg", "{}/collision.svg"],
    "log.csv": ["run", "gas.toml", "--until", "1", "--log-collisions", "{}/log.csv"],
}


class Writing(BadInputTest):
    def setUp(self):
        super().setUp()
        self.write("scene.toml", TWO_DISKS)
        self.succeed("make", "gas", "--disks", "500", "--packing", "0.5", "-o", "gas.toml")
        self.succeed("convert", "gas.toml", "gas.toml")  # with every disk written out

    @staticmethod
    def each_writer(folder):
        return [(name, [word.format(folder) for word in words]) for name, words in WRITERS.items()]

    def assert_old_content(self, folder, *names):
        """Only the old file is there, as it was."""
        self.assertEqual(sorted(p.name for p in pathlib.Path(folder).iterdir()), sorted(names))
        for name in names:
            self.assertEqual((pathlib.Path(folder) / name).read_text(), "old")

    def test_missing_directory(self):
        for name, words in self.each_writer("no/where"):
            if name != "final.xyz":  # run makes its directory
                self.refuse(words, 1, f"no/where/{name}", "No such file")
        self.write("file", "old")
        self.refuse(["run", "scene.toml", "--until", "1", "--out", "file"], 1, "file: ", "not a directory")
        self.refuse(["run", "scene.toml", "--until", "1", "--out", "file/below"], 1, "file")
        self.assertEqual(self.read("file"), "old")

    def test_directory_that_may_not_be_written(self):
        self.directory.chmod(0o755)
        self.path("shut").mkdir(mode=0o555)
        for name, words in self.each_writer("shut"):
            done = self.carom(*words, preexec_fn=become_nobody)
            self.assert_refused(done, 1, "shut", "Permission denied")
            self.assert_old_content(self.path("shut"))

    def test_file_size_limit(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))

        for name, words in self.each_writer("out"):
            self.path("out").mkdir(exist_ok=True)
            if name == "log.csv":  # grows while the run goes on: an old one is gone when the run begins
                self.refuse(words, 1, "out/log.csv", "File too large", preexec_fn=limit)
            elif name != "final.xyz":
                self.write(f"out/{name}", "old")
                self.refuse(words, 1, f"out/{name}", "File too large", preexec_fn=limit)
                self.assert_old_content(self.path("out"), name)
            for path in self.path("out").iterdir():
                path.unlink()
        self.refuse(["run", "gas.toml", "--until", "1", "--out", "out"], 1, "File too large", preexec_fn=limit)
        self.assertFalse(self.path("out/final.xyz").exists())

    def test_full_disk(self):
        with tempfile.TemporaryDirectory() as small:
            mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", small], capture_output=True)
            if mounted.returncode != 0:
                self.skipTest("cannot mount a small file system")
            try:
                for name, words in self.each_writer(small):
                    if name in ("final.xyz", "log.csv"):
                        continue
                    (pathlib.Path(small) / name).write_text("old")
                    done = self.carom(*words)
                    if name != "collision.svg" or done.returncode != 0:
                        self.assert_refused(done, 1, name, "No space left")
                        self.assert_old_content(small, name)
                    (pathlib.Path(small) / name).unlink()
                self.refuse(["run", "gas.toml", "--until", "1", "--log-collisions", f"{small}/log.csv"], 1,
                            "log.csv", "No space left")
            finally:
                subprocess.run(["umount", small], check=True)

    def test_full_standard_output(self):
        for words in (["run", "scene.toml", "--until", "1"], ["run", "scene.toml", "--until", "1", "--json"],
                      ["check", "scene.toml"], ["info", "scene.toml"], ["make", "--list"], ["make", "break", "-o", "-"],
                      ["collide", "--disk", "0,0,1,0", "--disk", "1,0,0,0"], ["--help"], ["run", "--help"],
                      ["--version"]):
            for redirection in (">/dev/full", ">&-"):
                with self.subTest(words=words, redirection=redirection):
                    done = subprocess.run(["/bin/sh", "-c", f'"$0" "$@" {redirection}', CAROM, *words], text=True,
                                          capture_output=True, cwd=self.directory)
                    self.assert_refused(done, 1, "standard output")

    def test_messages_never_end_up_in_a_file(self):
        for closed in (">&-", "2>&-", "<&- >&- 2>&-"):
            with self.subTest(closed=closed):
                subprocess.run(
                    ["/bin/sh", "-c", f'"$0" run gas.toml --until 1 --log-collisions log.csv --out "$1" {closed}', CAROM,
                     closed], cwd=self.directory, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                rows = self.read("log.csv").splitlines()
                self.assertEqual({row.count(",") for row in rows}, {7})

    def test_full_standard_error(self):
        done = subprocess.run(["/bin/sh", "-c", '"$0" check nowhere 2>/dev/full', CAROM], capture_output=True)
        self.assertEqual(done.returncode, 1)

    def test_a_reader_that_leaves_early(self):
        done = subprocess.run(["/bin/sh", "-c", '"$0" make cradle --disks 5000 -o - | head -n 1', CAROM],
                              capture_output=True, text=True)
        self.assertIn("title", done.stdout)
        self.assertEqual(done.stderr, "")

    def test_a_read_only_working_directory_does_not_matter(self):
        self.directory.chmod(0o555)
        done = self.carom("run", "scene.toml", "--until", "1", preexec_fn=become_nobody)
        self.assertEqual(done.returncode, 0, done.stderr)


class Paths(ProgramTest):
    def test_that_lead_nowhere(self):
        self.path("circle").symlink_to("circle")
        for path, reason in (("x" * 300, "File name too long"), ("circle", "Too many levels of symbolic links")):
            for words in (["info"], ["check"], ["run", "--until", 1], ["convert"], ["resume"], ["analyze"]):
                if words == ["resume"] and not HAS_HDF5:
                    continue
                more = ["a.xyz"] if words == ["convert"] else []
                with self.subTest(words=words, path=path):
                    self.assertIn(reason, self.refuse([*words, path, *more], 1, path[:100]).stderr)


if __name__ == "__main__":
    main()
