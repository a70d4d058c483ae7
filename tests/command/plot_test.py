"""`carom plot` draws every table of a run in every format asked for, whatever its cells hold and however it is named, and
says what is wrong where there is nothing to draw; `carom draw` tells disks apart by colour and makes whole films or
none."""

import json
import os
import shutil
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree

from program import CAROM, ProgramTest, main

GAS = '[box]\nboundary = "periodic"\n[[gas]]\ncount = 60\npacking_fraction = 0.4\n'


def column(name, label="", unit=""):
    return {"name": name, "label": label, "unit": unit}


class PlotTest(ProgramTest):
    def hand_made(self, tables, csv):
        """A run's directory with these tables of one observable; `csv`: file name → text."""
        self.path("o/observables").mkdir(parents=True, exist_ok=True)
        measurement = {"name": "thing", "estimates": [], "warnings": [], "tables": tables}
        self.write("o/observables/index.json", json.dumps({"observables": [measurement]}))
        for name, text in csv.items():
            self.write(f"o/observables/{name}", text)

    def assert_whole(self, path):
        data = self.path(path).read_bytes()
        if str(path).endswith(".svg"):
            xml.etree.ElementTree.fromstring(data)
            self.assertNotIn(b"nan", data)
        elif str(path).endswith(".png"):
            self.assertTrue(data.startswith(b"\x89PNG") and data[-8:-4] == b"IEND")
        else:
            self.assertTrue(data.startswith(b"%PDF-") and data.rstrip().endswith(b"%%EOF"))


class OfARun(PlotTest):
    def test_every_table_in_two_formats(self):
        self.write("gas.toml", GAS)
        self.succeed("run", "gas.toml", "--collisions", 3000, "--observe", "speeds,msd,pressure", "--out", "o")
        index = json.loads(self.read("o/observables/index.json"))
        tables = [table["name"] for entry in index["observables"] for table in entry["tables"]]
        self.assertGreaterEqual(len(tables), 2)
        files = self.json_of("plot", "o")["plots"]
        self.assertEqual(sorted(files), sorted(f"o/plots/{name}.{end}" for name in tables for end in ("svg", "png")))
        for file in files:
            self.assert_whole(file)

    def test_names_formats_and_place(self):
        self.write("gas.toml", GAS)
        self.succeed("run", "gas.toml", "--collisions", 2000, "--observe", "speeds,msd", "--out", "o")
        done = self.succeed("plot", "o", "msd", "--format", "pdf,svg,pdf", "-o", "elsewhere")
        self.assertEqual(done.stdout.split(), ["elsewhere/msd.pdf", "elsewhere/msd.svg"])
        for file in done.stdout.split():
            self.assert_whole(file)
        self.assertFalse(self.path("o/plots").exists())
        self.refuse(["plot", "o", "nonsense"], 1, "nonsense", "msd")
        self.refuse(["plot", "o", "--format", "gif"], 2, "gif")

    def test_odd_tables(self):
        tables = [{"name": "nan", "columns": [column("x"), column("y"), column("y_error")], "logarithmic_y": True},
                  {"name": "row", "columns": [column("x"), column("y")], "bars": True},
                  {"name": "header", "columns": [column("x"), column("y")]},
                  {"name": "nothing", "columns": []},
                  {"name": "ragged", "columns": [column("x"), column("y")]},
                  {"name": "unknown", "columns": [column("x")]}]
        self.hand_made(tables, {"nan.csv": "x,y,y_error\n1,nan,nan\n2,,1\n3,word,1\n4,inf,1\n5,1e400,\n6,2,nan\n",
                                "row.csv": "x,y\n1,2\n", "header.csv": "x,y\n", "nothing.csv": "",
                                "ragged.csv": "x,y\n1\n2,3,4\n\n5,6\n", "unknown.csv": "x,more\n1,2\n3,4\n"})
        files = self.json_of("plot", "o")["plots"]
        self.assertEqual(len(files), 12)
        for file in files:
            self.assert_whole(file)

    def test_names_are_only_names(self):
        odd = "$(touch hacked); `x` \"'<&> \\n set output 'y' \u03c8"
        tables = [{"name": odd, "file": "a.csv", "title": odd, "columns": [column("x", odd, odd), column(odd, odd)]},
                  {"name": "../../escaped", "file": "a.csv", "columns": [column("x"), column(odd)]},
                  {"name": odd, "file": "a.csv", "columns": [column("x"), column(odd)]}]
        self.hand_made(tables, {"a.csv": 'x,"' + odd.replace('"', '""') + '"\n1,2\n2,3\n'})
        before = set(os.listdir(self.directory))
        files = self.json_of("plot", "o")["plots"]
        self.assertEqual(len(set(files)), 6)
        for file in files:
            self.assertEqual(os.path.dirname(file), "o/plots")
            self.assert_whole(file)
        self.assertEqual(set(os.listdir(self.directory)), before)

    def test_nothing_outside_is_read(self):
        for file in ("../../secret.csv", "/etc/passwd", "..", ""):
            self.hand_made([{"name": "a", "file": file, "columns": [column("x"), column("y")]}], {})
            self.refuse(["plot", "o"], 1, "index.json")

    def test_where_there_is_nothing_to_draw(self):
        self.refuse(["plot", "missing"], 1, "missing")
        self.path("empty").mkdir()
        self.refuse(["plot", "empty"], 1, "neither a run nor a sweep")
        self.write("gas.toml", GAS)
        self.succeed("run", "gas.toml", "--collisions", 5, "--out", "plain")
        self.refuse(["plot", "plain"], 1, "--observe")
        self.hand_made([{"name": "a", "columns": [column("x")]}], {})
        self.refuse(["plot", "o"], 1, "a.csv")
        for text in ("", "[", "[]", '{"observables": 3}', '{"observables": [{"tables": [{}]}]}', '{"observables": [7]}'):
            self.write("o/observables/index.json", text)
            self.refuse(["plot", "o"], 1, "index.json")


class Draw(PlotTest):
    def setUp(self):
        super().setUp()
        self.write("gas.toml", GAS)

    def test_colours(self):
        pictures = set()
        for colour in ("species", "speed", "psi6", "density"):
            self.succeed("draw", "gas.toml", "--time", 0.5, "--colour", colour, "-o", "a.svg")
            self.assert_whole("a.svg")
            pictures.add(self.read("a.svg"))
        self.assertEqual(len(pictures), 4)
        self.refuse(["draw", "gas.toml", "--colour", "taste", "-o", "a.svg"], 2, "taste", "psi6")

    def test_options_that_make_no_sense(self):
        for words, part in ((["gas.toml"], "--movie"), (["gas.toml", "-o", "a.svg", "--movie", "a.mp4"], "either"),
                            (["gas.toml", "-o", "a.svg", "--fps", 3], "--movie"),
                            (["gas.toml", "--movie", "a.mp4"], "--until"),
                            (["gas.toml", "--movie", "a.mp4", "--until", 1, "--fps", 0], "--fps"),
                            (["gas.toml", "--movie", "a.mp4", "--until", 0], "--until"),
                            (["gas.toml", "--movie", "a.mp4", "--until", 1, "--every", 0], "--every"),
                            (["gas.toml", "--movie", "a.mp4", "--until", 1, "--every", 1e-9], "--every"),
                            (["gas.toml", "--movie", "a.mp4", "--until", 1, "--time", 1], "--time")):
            self.refuse(["draw", *words], 2, part)
        self.refuse(["draw", "gas.toml", "--movie", "a.avi", "--until", 1], 1, ".mp4")

    def test_films_need_ffmpeg(self):
        self.path("bin").mkdir()
        done = self.carom("draw", "gas.toml", "--movie", "a.mp4", "--until", 1, env={**os.environ, "PATH": "bin"})
        self.assert_refused(done, 1, "ffmpeg", "not installed")
        self.assertEqual(sorted(os.listdir(self.directory)), ["bin", "gas.toml"])

    def test_an_interrupted_film_is_not_there(self):
        self.path("bin").mkdir()
        self.write("bin/ffmpeg", '#!/bin/sh\n/bin/cat > /dev/null\n')
        self.path("bin/ffmpeg").chmod(0o755)
        child = subprocess.Popen([CAROM, "draw", "gas.toml", "--movie", "a.mp4", "--until", "1000", "--every", "0.1"],
                                 cwd=self.directory, env={**os.environ, "PATH": str(self.path("bin"))})
        deadline = time.monotonic() + 60
        while not list(self.directory.glob(".carom-film-*")):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)
        time.sleep(0.1)
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.wait(timeout=60), 130)
        self.assertEqual(sorted(os.listdir(self.directory)), ["bin", "gas.toml"])

    @unittest.skipUnless(shutil.which("ffmpeg") and shutil.which("ffprobe"), "ffmpeg is not installed")
    def test_films(self):
        self.succeed("run", "gas.toml", "--until", 1, "--every", 0.25, "--out", "o")
        for words, name, frames in ((["gas.toml", "--until", 1, "--every", 0.1, "--colour", "speed"], "a.mp4", 11),
                                    (["o/trajectory.xyz", "--fps", 5, "--colour", "psi6"], "b.gif", 5)):
            self.succeed("draw", *words, "--movie", name, "--width", 301)
            probe = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames",
                                    "-of", "csv=p=0", name], cwd=self.directory, capture_output=True, text=True,
                                   check=True)
            self.assertEqual(int(probe.stdout.strip().strip(",")), frames)
        self.assertFalse(list(self.directory.glob(".carom-film-*")))
        self.refuse(["draw", "o/trajectory.xyz", "--movie", "b.gif", "--until", 1], 2, "trajectory")


if __name__ == "__main__":
    main()
