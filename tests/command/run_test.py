"""`carom run` ends where it is told to, reports what the contract names, leaves its files complete and reproducible, shows
progress only where someone sees it, and keeps its results when it is interrupted."""

import csv
import fcntl
import json
import os
import pty
import select
import signal
import struct
import subprocess
import termios
import time

from program import CAROM, HAS_HDF5, SCENES, TWO_DISKS, ProgramTest, main

KEYS = """disks packing_fraction time collisions wall_collisions wall_seconds collisions_per_second threads patches solver
simd windows windows_repaired ties max_overlap energy_drift momentum_drift temperature pressure digest scene_digest
version command compiler""".split()


class RunTest(ProgramTest):
    def gas(self, name="gas.toml", disks=100, packing=0.4, *more):
        self.succeed("make", "gas", "--disks", disks, "--packing", packing, *more, "-o", name)
        return name

    def frames(self, name):
        """The frames of an extended XYZ file as (time, rows)."""
        lines = self.read(name).splitlines()
        frames = []
        while lines:
            count = int(lines[0])
            (start,) = [word for word in lines[1].split() if word.startswith("Time=")]
            frames.append((float(start[5:]), [line.split() for line in lines[2:2 + count]]))
            self.assertEqual(len(frames[-1][1]), count)
            lines = lines[2 + count:]
        return frames


class Report(RunTest):
    def test_all_keys_are_there(self):
        report = self.json_of("run", self.gas(), "--collisions", 100)
        self.assertEqual(sorted(set(KEYS) - set(report)), [])
        self.assertRegex(report["digest"], "^[0-9a-f]{16}$")
        self.assertEqual(report["command"], "carom run gas.toml --collisions 100 --json")
        self.assertEqual((report["disks"], report["threads"]), (100, 1))

    def test_galperin_counts_digits_of_pi(self):
        self.succeed("make", "galperin", "--digits", 4, "-o", "pi.toml")
        report = self.json_of("run", "pi.toml")
        self.assertEqual(report["collisions"] + report["wall_collisions"], 3141)

    def test_a_gas_keeps_its_energy_and_momentum(self):
        report = self.json_of("run", self.gas(disks=400, packing=0.6), "--collisions", 20000)
        self.assertGreaterEqual(report["collisions"], 20000)
        self.assertLess(abs(report["energy_drift"]), 1e-12)
        self.assertLess(abs(report["momentum_drift"]), 1e-12)
        self.assertLess(report["max_overlap"], 1e-12)
        self.assertAlmostEqual(report["temperature"], 1, delta=1e-12)
        self.assertAlmostEqual(report["packing_fraction"], 0.6, delta=1e-12)

    def test_text_for_people(self):
        text = self.succeed("run", SCENES / "two-disk.toml").stdout
        self.assertIn("disk collisions   1\n", text)
        self.assertIn("digest", text)


class End(RunTest):
    def test_until(self):
        report = self.json_of("run", self.gas(), "--until", 0.3)
        self.assertEqual(report["time"], 0.3)

    def test_until_zero_is_the_start(self):
        report = self.json_of("run", self.gas(), "--until", 0)
        self.assertEqual((report["time"], report["collisions"], report["windows"]), (0, 0, 0))

    def test_collisions_end_at_the_first_window_end_that_has_them(self):
        gas = self.gas()
        report = self.json_of("run", gas, "--collisions", 1000)
        self.assertGreaterEqual(report["collisions"], 1000)
        # It is a window's end: going on from there, however little, is another window.
        beyond = self.json_of("run", gas, "--until", report["time"] * (1 + 1e-9))
        self.assertEqual(beyond["windows"], report["windows"] + 1)
        self.assertEqual(self.json_of("run", gas, "--until", report["time"])["digest"], report["digest"])
        # And the first one with so many.
        fewer = self.json_of("run", gas, "--collisions", report["collisions"])
        self.assertEqual(fewer["digest"], report["digest"])
        more = self.json_of("run", gas, "--collisions", report["collisions"] + 1)
        self.assertEqual(more["windows"], report["windows"] + 1)

    def test_both_whichever_comes_first(self):
        gas = self.gas()
        self.assertEqual(self.json_of("run", gas, "--collisions", 10**9, "--until", 0.1)["time"], 0.1)
        self.assertLess(self.json_of("run", gas, "--collisions", 1, "--until", 1e9)["windows"], 3)

    def test_the_command_line_replaces_the_scenes_own_end(self):
        self.write("scene.toml", TWO_DISKS + "[run]\nuntil = 5.0\n")
        self.assertEqual(self.json_of("run", "scene.toml")["time"], 5)
        self.assertEqual(self.json_of("run", "scene.toml", "--until", 7)["time"], 7)
        self.assertGreater(self.json_of("run", "scene.toml", "--collisions", 5)["time"], 5)

    def test_no_end_anywhere(self):
        self.write("scene.toml", TWO_DISKS)
        self.refuse(["run", "scene.toml"], 2, "scene.toml", "--until", "--collisions")

    def test_nothing_left_to_happen_ends_the_run_with_a_note(self):
        open_plane = '[box]\nboundary = "open"\n[[disk]]\nposition = [0.0, 0.0]\nvelocity = [-1.0, 0.0]\n'
        single = '[box]\nsize = [4.0, 4.0]\n[[disk]]\nposition = [1.0, 1.0]\nvelocity = [1.0, 0.5]\n'
        apart = open_plane + "[[disk]]\nposition = [3.0, 0.0]\nvelocity = [1.0, 0.0]\n"
        for text in (single, apart, open_plane):
            self.write("scene.toml", text)
            done = self.succeed("run", "scene.toml", "--collisions", 5, "--json")
            self.assertEqual(json.loads(done.stdout)["collisions"], 0)
            self.assertIn("carom: no two disks meet any more", done.stderr)

    def test_one_disk(self):
        self.write("scene.toml", '[box]\nsize = [4.0, 4.0]\nboundary = "reflecting"\n'
                                 "[[disk]]\nposition = [1.0, 1.0]\nvelocity = [1.0, 0.0]\n")
        report = self.json_of("run", "scene.toml", "--until", 10)
        self.assertEqual((report["disks"], report["collisions"], report["wall_collisions"]), (1, 0, 3))
        self.assertEqual(report["energy_drift"], 0)


class Options(RunTest):
    def test_values_that_make_no_sense(self):
        gas = self.gas()
        for words, code in ((["--until", "-1"], 1), (["--until", "nan"], 2), (["--until", "1e400"], 2),
                            (["--until", "5x"], 2), (["--until", ""], 2), (["--until"], 2), (["--collisions", "0"], 1),
                            (["--collisions", "-5"], 2), (["--collisions", "1.5"], 2), (["--collisions", ""], 2),
                            (["--collisions", "99999999999999999999"], 2), (["--seed", "-1"], 2),
                            (["--seed", "0x10"], 2), (["--until", "1", "--solver", "magic"], 2),
                            (["--until", "1", "--trajectory", "mp4"], 2), (["--until", "1", "--equilibrate", "-1"], 1),
                            (["--until", "1", "--every", "0", "--out", "o"], 1), (["--until", "1", "--every", "1"], 2),
                            (["--until", "1", "--trajectory", "xyz"], 2), (["--until", "1", "--overwrite"], 2),
                            (["--until", "1", "--until", "2"], 2), (["--until", "1", "--out", ""], 2),
                            (["--until", "1", "--out", "o", "--trajectory", "xyz"], 2),
                            (["--until", "1", "--threads", "0"], 1), (["--until", "1", "--threads", "two"], 2),
                            (["--until", "1", "--threads", "1e9"], 1), (["--until", "1", "--patches", "0x2"], 1),
                            (["--until", "1", "--patches", "3"], 2), (["--until", "1", "--patches", "2x2x2"], 2),
                            (["--until", "1", "--patches", "2xb"], 2), (["--until", "1", "--patches", "9999x1"], 1)):
            with self.subTest(words=words):
                done = self.refuse(["run", gas, *words], code, "--")
                self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertFalse(self.path("o").exists())

    def test_patches_and_threads_change_no_bit(self):
        gas = self.gas("gas.toml", 3000, 0.7)
        plain = self.json_of("run", gas, "--collisions", 60000)
        self.assertEqual((plain["threads"], plain["patches"], plain["duplicated_work"]), (1, 1, 0))
        for words in (["--patches", "3x2"], ["--threads", 2, "--patches", "2x2"], ["--threads", 2], ["--threads", 3]):
            with self.subTest(words=words):
                report = self.json_of("run", gas, "--collisions", 60000, *words)
                for key in ("digest", "collisions", "pressure", "max_overlap", "energy_drift", "windows"):
                    self.assertEqual(report[key], plain[key], key)
                if "--patches" in words:
                    self.assertEqual(report["patches"], 6 if "3x2" in words else 4)
                    self.assertGreater(report["duplicated_work"], 0)
                    self.assertGreater(report["phase_seconds"]["advance"], 0)
        small = self.json_of("run", self.gas("small.toml", 50), "--collisions", 1000, "--threads", 2)
        self.assertEqual((small["threads"], small["patches"]), (1, 1))

    def test_counts_may_be_written_with_an_exponent_and_are_never_octal(self):
        gas = self.gas()
        self.assertEqual(self.json_of("run", gas, "--collisions", "2e2")["digest"],
                         self.json_of("run", gas, "--collisions", "200")["digest"])
        self.assertEqual(self.json_of("run", gas, "--until", 0.2, "--seed", "010")["digest"],
                         self.json_of("run", gas, "--until", 0.2, "--seed", "10")["digest"])

    def test_seed(self):
        gas = self.gas()
        digests = [self.json_of("run", gas, "--until", 0.5, "--seed", seed)["digest"] for seed in (1, 2, 2)]
        self.assertNotEqual(digests[0], digests[1])
        self.assertEqual(digests[1], digests[2])
        self.assertEqual(digests[0], self.json_of("run", gas, "--until", 0.5)["digest"])
        self.refuse(["run", SCENES / "two-disk.toml", "--seed", 2], 2, "--seed", "random")

    def test_outputs_never_change_the_trajectory(self):
        gas = self.gas()
        plain = self.json_of("run", gas, "--until", 2)
        busy = self.json_of("run", gas, "--until", 2, "--out", "o", "--every", 0.07, "--log-collisions", "c.csv")
        self.assertEqual(busy["digest"], plain["digest"])

    def test_quiet_and_no_terminal_leave_stderr_empty(self):
        gas = self.gas()
        self.assertEqual(self.succeed("run", gas, "--until", 1).stderr, "")
        self.assertEqual(self.succeed("run", gas, "--until", 1, "--quiet").stderr, "")

    def test_locale_does_not_matter(self):
        gas = self.gas()
        outputs = {self.json_of("run", gas, "--until", "0.5", env=dict(os.environ, LC_ALL=name, LANG=name))["digest"]
                   for name in ("C", "de_DE.UTF-8", "en_US.UTF-8")}
        self.assertEqual(len(outputs), 1)


class Sources(RunTest):
    ROWS = "2\n0.25 0.5 0.1 0.0 0.05 1.0 0 0 0\n0.75 0.5 -0.1 0.0 0.05 1.0 255 0 0\n"

    def test_standard_input(self):
        self.write("scene.toml", TWO_DISKS)
        from_file = self.json_of("run", "scene.toml", "--until", 5)
        from_stdin = self.json_of("run", "-", "--until", 5, stdin=TWO_DISKS)
        self.assertEqual(from_stdin["digest"], from_file["digest"])

    def test_pipe_with_a_name(self):
        os.mkfifo(self.path("pipe"))
        self.write("scene.toml", TWO_DISKS)
        writer = subprocess.Popen(["cp", "scene.toml", "pipe"], cwd=self.directory)
        report = self.json_of("run", "pipe", "--until", 5)
        writer.wait()
        self.assertEqual(report["digest"], self.json_of("run", "scene.toml", "--until", 5)["digest"])

    def test_algs4(self):
        self.write("two.txt", self.ROWS)
        report = self.json_of("run", "two.txt", "--until", 4)
        # Head-on at time 2, back at the walls at times 2 + 0.4/0.1 = 6.
        self.assertEqual((report["collisions"], report["wall_collisions"]), (1, 0))
        self.assertEqual(self.json_of("run", "two.txt", "--until", 7)["wall_collisions"], 2)

    def test_extended_xyz(self):
        gas = self.gas()
        self.succeed("convert", gas, "gas.xyz")
        self.assertEqual(self.json_of("run", "gas.xyz", "--until", 1)["digest"],
                         self.json_of("run", gas, "--until", 1)["digest"])


class Files(RunTest):
    def test_directory_holds_the_run(self):
        report = self.json_of("run", self.gas(), "--until", 1.5, "--out", "some/where")
        checkpoints = ["checkpoint-1.h5", "checkpoint.h5"] if HAS_HDF5 else []
        self.assertEqual(sorted(p.name for p in self.path("some/where").iterdir()),
                         [*checkpoints, "final.xyz", "report.json", "scene.toml"])
        self.assertEqual(json.loads(self.read("some/where/report.json")), report)
        ((end, rows),) = self.frames("some/where/final.xyz")
        self.assertEqual((end, len(rows)), (1.5, 100))
        # 17 significant digits: every number reads back to itself.
        digits = [len(word.split("e")[0].lstrip("-0.").replace(".", "")) for row in rows for word in row[1:3]]
        self.assertGreater(sum(d >= 16 for d in digits), 150)
        self.assertLessEqual(max(digits), 17)

    def test_the_scene_as_run_runs_again(self):
        report = self.json_of("run", self.gas(), "--until", 1.5, "--out", "o")
        again = self.json_of("run", "o/scene.toml")
        for key in ("digest", "scene_digest", "collisions", "time"):
            self.assertEqual(again[key], report[key])

    def test_the_end_of_one_run_starts_another(self):
        self.json_of("run", self.gas(), "--until", 1.5, "--out", "o")
        self.assertGreater(self.json_of("run", "o/final.xyz", "--until", 1)["collisions"], 0)

    def test_trajectory(self):
        self.json_of("run", self.gas(), "--until", 1, "--out", "o", "--every", 0.25)
        frames = self.frames("o/trajectory.xyz")
        self.assertEqual([when for when, _ in frames], [0, 0.25, 0.5, 0.75, 1])
        self.assertEqual(frames[-1], self.frames("o/final.xyz")[0])

    def test_the_last_frame_is_not_lost_to_rounding(self):
        self.json_of("run", self.gas(), "--until", 0.3, "--out", "o", "--every", 0.1)  # 3 * 0.1 > 0.3
        frames = self.frames("o/trajectory.xyz")
        self.assertEqual([when for when, _ in frames], [0, 0.1, 0.2, 0.3])
        self.assertEqual(frames[-1], self.frames("o/final.xyz")[0])

    def test_a_bad_log_file_leaves_no_half_begun_run(self):
        self.refuse(["run", self.gas(), "--until", 1, "--out", "o", "--log-collisions", "nowhere/log.csv"], 1, "nowhere")
        self.json_of("run", self.gas(), "--until", 1, "--out", "o")

    def test_an_old_run_is_kept_unless_overwritten(self):
        gas = self.gas()
        self.json_of("run", gas, "--until", 1, "--out", "o", "--every", 0.5)
        before = {p.name: p.read_bytes() for p in self.path("o").iterdir()}
        self.refuse(["run", gas, "--until", 2, "--out", "o"], 1, "o: ", "overwrite")
        self.assertEqual({p.name: p.read_bytes() for p in self.path("o").iterdir()}, before)
        report = self.json_of("run", gas, "--until", 2, "--out", "o", "--overwrite")
        self.assertEqual(json.loads(self.read("o/report.json")), report)
        self.assertFalse(self.path("o/trajectory.xyz").exists())

    def test_overwriting_the_directory_of_the_scene_itself(self):
        first = self.json_of("run", self.gas(), "--until", 1, "--out", "o")
        again = self.json_of("run", "o/scene.toml", "--out", "o", "--overwrite")
        self.assertEqual(first["digest"], again["digest"])

    def test_collision_log(self):
        self.succeed("make", "gas", "--disks", 50, "--packing", 0.3, "--boundary", "reflecting", "-o", "gas.toml")
        report = self.json_of("run", "gas.toml", "--until", 2.7, "--log-collisions", "log.csv")
        rows = list(csv.DictReader(self.read("log.csv").splitlines()))
        self.assertEqual(list(rows[0]), "time,i,j,x,y,nx,ny,impulse".split(","))
        walls = [row for row in rows if not row["j"].isdigit()]
        self.assertEqual(len(rows) - len(walls), report["collisions"])
        self.assertEqual(len(walls), report["wall_collisions"])
        self.assertEqual({row["j"] for row in walls}, {"left", "right", "bottom", "top"})
        times = [float(row["time"]) for row in rows]
        self.assertEqual(times, sorted(times))
        self.assertLess(times[-1], 2.7)
        for row in rows:
            self.assertAlmostEqual(float(row["nx"]) ** 2 + float(row["ny"]) ** 2, 1, delta=1e-14)
            self.assertGreater(float(row["impulse"]), 0)
            if row["j"].isdigit():
                self.assertLess(int(row["i"]), int(row["j"]))

    def test_the_collision_log_never_replaces_the_scene(self):
        gas = self.gas()
        text = self.read(gas)
        self.refuse(["run", gas, "--until", 1, "--log-collisions", "./gas.toml"], 2, "--log-collisions")
        self.assertEqual(self.read(gas), text)


class Terminal(RunTest):
    def on_terminal(self, columns, *words):
        """What the program writes to a terminal as its stderr."""
        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        child = subprocess.Popen([CAROM, *map(str, words)], stdout=subprocess.PIPE, stderr=slave, cwd=self.directory)
        os.close(slave)
        shown = b""
        while True:
            try:
                piece = os.read(master, 65536)
            except OSError:  # Linux: the other side is closed
                break
            if not piece:
                break
            shown += piece
        os.close(master)
        output = child.communicate()[0]
        self.assertEqual(child.returncode, 0)
        return shown.decode(), output.decode()

    def test_a_bar_that_fits_and_goes_away(self):
        gas = self.gas(disks=200, packing=0.6)
        for columns in (200, 80, 40, 20, 5):
            with self.subTest(columns=columns):
                shown, output = self.on_terminal(columns, "run", gas, "--collisions", 8000, "--json")
                lines = [line.replace("\x1b[K", "") for line in shown.split("\r")]
                self.assertTrue(any(lines), "no bar")
                self.assertLess(max(map(len, lines)), columns)
                self.assertNotIn("\n", shown)
                self.assertTrue(shown.endswith("\r\x1b[K"))
                if columns >= 20:
                    self.assertIn("%", shown)
                if columns >= 80:
                    self.assertRegex(shown, r"\[=* *\].*t = .*collisions/s")
                json.loads(output)

    def test_quiet_shows_none(self):
        shown, _ = self.on_terminal(80, "run", self.gas(), "--collisions", 3000, "--quiet")
        self.assertEqual(shown, "")


class Interrupts(RunTest):
    def start(self, *words):
        child = subprocess.Popen([CAROM, "run", *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 text=True, cwd=self.directory)
        self.addCleanup(child.stdout.close)
        self.addCleanup(child.stderr.close)
        self.addCleanup(child.wait)
        self.addCleanup(child.kill)
        return child

    def wait_for(self, path):
        deadline = time.monotonic() + 60
        while not (self.path(path).exists() and self.path(path).stat().st_size > 0):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)

    def test_the_first_signal_keeps_the_results(self):
        gas = self.gas()
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number=number):
                out = f"o{number}"
                child = self.start(gas, "--until", 1e9, "--out", out, "--every", 0.5, "--json")
                self.wait_for(f"{out}/trajectory.xyz")
                child.send_signal(number)
                output, errors = child.communicate(timeout=60)
                self.assertEqual(child.returncode, 130)
                report = json.loads(output)
                self.assertEqual(json.loads(self.read(f"{out}/report.json")), report)
                self.assertIn(f"Time={report['time']:g}", self.read(f"{out}/final.xyz").splitlines()[1])
                self.assertLessEqual(self.frames(f"{out}/trajectory.xyz")[-1][0], report["time"])
                self.assertIn("carom: interrupted", errors)
                self.assertEqual(f"carom resume {out} goes on" in errors, HAS_HDF5)
                # What is kept is the true state at that time.
                again = self.json_of("run", gas, "--until", report["time"])
                self.assertEqual(again["digest"], report["digest"])

    def test_frames_closer_than_events_can_be_interrupted(self):
        self.write("scene.toml", TWO_DISKS)
        child = self.start("scene.toml", "--until", 1, "--out", "o", "--every", "1e-300")
        self.wait_for("o/trajectory.xyz")
        child.send_signal(signal.SIGINT)
        child.communicate(timeout=20)
        self.assertEqual(child.returncode, 130)

    def test_the_second_signal_ends_at_once(self):
        # Opening a window of this many disks takes the reference solver long; the flag is looked at between events.
        gas = self.gas("large.toml", 20000, 0.4)
        for first, second in ((signal.SIGINT, signal.SIGTERM), (signal.SIGTERM, signal.SIGTERM)):
            with self.subTest(first=first):
                out = f"o{first}"
                child = self.start(gas, "--until", 1e9, "--out", out)
                self.wait_for(f"{out}/scene.toml")
                child.send_signal(first)
                time.sleep(0.1)
                child.send_signal(second)
                begin = time.monotonic()
                child.communicate(timeout=60)
                self.assertLess(time.monotonic() - begin, 5)
                self.assertIn(child.returncode, (-second, 130))

    def test_a_closed_terminal_does_not_end_the_run(self):
        gas = self.gas(disks=200, packing=0.6)
        master, slave = pty.openpty()
        child = subprocess.Popen([CAROM, "run", gas, "--collisions", "8000", "--json"], stdout=subprocess.PIPE,
                                 stderr=slave, cwd=self.directory)
        os.close(slave)
        select.select([master], [], [], 60)
        os.close(master)
        output = child.communicate()[0]
        self.assertEqual(child.returncode, 0)
        self.assertGreaterEqual(json.loads(output)["collisions"], 8000)


class Pipes(ProgramTest):
    def test_a_log_into_a_named_pipe(self):
        self.write("scene.toml", TWO_DISKS)
        os.mkfifo(self.path("pipe"))
        with subprocess.Popen(["cat", "pipe"], stdout=subprocess.PIPE, text=True, cwd=self.directory) as reader:
            self.addCleanup(reader.kill)
            words = ["run", "scene.toml", "--until", 30, "--log-collisions"]
            done = subprocess.run([CAROM, *map(str, words), "pipe"], cwd=self.directory, timeout=10, check=False,
                                  capture_output=True)
            self.assertEqual(done.returncode, 0)
            self.succeed(*words, "log.csv")
            self.assertEqual(reader.stdout.read(), self.read("log.csv"))


if __name__ == "__main__":
    main()
