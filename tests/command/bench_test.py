"""`carom bench` lists its scenes by name, times what is asked for and reports it with the same digest every time;
CAROM_SIMD chooses instructions, never bits; scripts/bench computes its ratios from what the two programs print."""

import json
import os
import signal
import subprocess
import sys
import time

from program import CAROM, SOURCE, ProgramTest, main

KEYS = """name disks packing_fraction collisions wall_collisions seconds collisions_per_second ns_per_collision
load_seconds first_window_seconds energy_drift bytes_per_disk solver simd threads patches
patches_repaired duplicated_work digest""".split()
TINY = ["--disks", 60, "--packing", 0.4, "--collisions-per-disk", 10]
SIMD_NAMES = ("scalar", "SSE4", "AVX2", "AVX-512")


class List(ProgramTest):
    def names(self):
        return [line.split()[0] for line in self.succeed("bench", "--list").stdout.splitlines()]

    def test_every_size_and_density_of_equal_disks(self):
        names = self.names()
        self.assertEqual(len(set(names)), len(names))
        for disks in ("1e3", "1e4", "1e5", "1e6", "1e7"):
            for packing in ("0.05", "0.20", "0.50", "0.70", "0.80"):
                self.assertIn(f"gas-{disks}-{packing}", names)
        for family in ("bidisperse", "masses-10", "walls"):
            self.assertTrue([name for name in names if name.startswith(f"{family}-1e4-")], family)

    def test_a_beginning_chooses_all_that_begin_so(self):
        report = self.json_of("bench", "gas-1e3-0.", "--collisions-per-disk", 0.01)
        self.assertEqual([result["name"] for result in report["benchmarks"]],
                         [name for name in self.names() if name.startswith("gas-1e3-")])

    def test_a_name_means_the_scene_it_says(self):
        for name, disks, packing in (("gas-1e3-0.70", 1000, 0.7), ("gas-1e3-0.05", 1000, 0.05)):
            (result,) = self.json_of("bench", name, "--collisions-per-disk", 0.01)["benchmarks"]
            self.assertEqual((result["name"], result["disks"]), (name, disks))
            self.assertAlmostEqual(result["packing_fraction"], packing, delta=1e-12)


class Results(ProgramTest):
    def result(self, *words, **options):
        (result,) = self.json_of("bench", *words, **options)["benchmarks"]
        return result

    def test_keys_and_what_they_say_of_each_other(self):
        result = self.result(*TINY)
        self.assertEqual(sorted(KEYS), sorted(result))
        self.assertEqual((result["name"], result["disks"]), ("gas-60-0.4", 60))
        self.assertGreaterEqual(result["collisions"], 300)
        rate = result["collisions"] / result["seconds"]
        self.assertAlmostEqual(result["collisions_per_second"] / rate, 1, delta=1e-9)
        self.assertAlmostEqual(result["ns_per_collision"] * rate / 1e9, 1, delta=1e-9)
        self.assertLess(abs(result["energy_drift"]), 1e-12)

    def test_the_same_digest_in_patches_on_two_threads(self):
        divided = self.result(*TINY, "--threads", 2, "--patches", "2x1")
        self.assertEqual((divided["threads"], divided["patches"]), (2, 2))
        self.assertEqual(divided["digest"], self.result(*TINY)["digest"])

    def test_the_same_digest_every_time_and_with_every_solver(self):
        self.assertEqual(len({self.result(*TINY, "--solver", solver)["digest"]
                              for solver in ("fast", "reference", "fast")}), 1)

    def test_memory_is_shared_by_the_disks(self):
        few, many = (self.result("--disks", disks, "--packing", 0.5, "--collisions-per-disk", 0.01)["bytes_per_disk"]
                     for disks in (1000, 8000))
        self.assertGreater(many, 100)
        self.assertLess(many, few / 2)  # of few disks most is the program's own

    def test_table_for_people(self):
        lines = self.succeed("bench", *TINY).stdout.splitlines()
        self.assertRegex(lines[0], r"^carom .*, solver \w+, ")
        heading, row = lines[-2].split("  "), lines[-1].split()
        self.assertEqual(heading[0], "benchmark")
        self.assertEqual(row[:3], ["gas-60-0.4", "60", "0.4000"])
        self.assertRegex(row[-1], "^[0-9a-f]{16}$")

    def wait_until_caught(self, child, number):
        """Until the program has a handler for this signal."""
        deadline = time.monotonic() + 60
        while True:
            with open(f"/proc/{child.pid}/status", encoding="utf-8") as status:
                (caught,) = [int(line.split()[1], 16) for line in status if line.startswith("SigCgt:")]
            if caught >> (number - 1) & 1:
                return
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)

    def test_interrupted(self):
        child = subprocess.Popen([CAROM, "bench", "--disks", "60", "--packing", "0.4", "--collisions-per-disk", "1e9",
                                  "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.wait_until_caught(child, signal.SIGINT)
        child.send_signal(signal.SIGINT)
        output, errors = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 130)
        self.assertEqual(json.loads(output)["benchmarks"], [])
        self.assertEqual(errors.splitlines(), ["carom: interrupted; 0 of 1 benchmarks are done"])


class Refusals(ProgramTest):
    def test_unknown_name(self):
        self.refuse(["bench", "gas-2e4-0.70"], 2, "'gas-2e4-0.70'", "gas-1e4-0.70", "--list")
        self.refuse(["bench", "bidispers-1e4-0.50"], 2, "bidisperse-1e4-0.50")
        self.refuse(["bench", ""], 2, "empty", "--list")

    def test_options_that_make_no_sense(self):
        for words in (["--disks", "60"], ["--packing", "0.4"], ["gas-1e3", "--disks", "60", "--packing", "0.4"],
                      ["--disks", "1", "--packing", "0.4"], ["--collisions-per-disk", "0"], ["--list", "gas"],
                      ["--list", "--json"], ["--solver", "magic"], ["gas", "gas"]):
            with self.subTest(words=words):
                self.refuse(["bench", *words], 2)

    def test_scenes_that_cannot_be(self):
        self.refuse(["bench", "--disks", "60", "--packing", "0.95"], 1, "0.95")
        self.refuse(["bench", "--disks", "60", "--packing", "0"], 1, "packing")
        self.refuse(["bench", "--disks", "1e15", "--packing", "0.1"], 1, "memory")


class Instructions(ProgramTest):
    """CAROM_SIMD. Which instructions there are to choose from depends on the processor."""

    def environment(self, value):
        return dict(os.environ, CAROM_SIMD=value)

    def test_same_bits_or_a_clear_error(self):
        free = self.json_of("bench", *TINY)["benchmarks"][0]
        chosen = 0
        for name in SIMD_NAMES:
            done = self.carom("bench", *TINY, "--json", env=self.environment(name))
            if done.returncode != 0:
                self.assert_refused(done, 1, "CAROM_SIMD", name, "processor", "scalar")
                continue
            (result,) = json.loads(done.stdout)["benchmarks"]
            self.assertEqual(result["digest"], free["digest"], name)
            if result["solver"] == "fast":
                self.assertEqual(result["simd"], name)
            chosen += 1
        self.assertGreaterEqual(chosen, 1)

    def test_run_heeds_it_too(self):
        self.succeed("make", "gas", "--disks", 50, "--packing", 0.3, "-o", "gas.toml")
        report = self.json_of("run", "gas.toml", "--until", 1, env=self.environment("SCALAR"))
        self.assertEqual(report["simd"], "scalar")
        self.assertEqual(report["digest"], self.json_of("run", "gas.toml", "--until", 1)["digest"])

    def test_unknown_names(self):
        self.succeed("make", "gas", "--disks", 50, "--packing", 0.3, "-o", "gas.toml")
        for value in ("AVX1024", "avx 2", " "):
            for words in (["run", "gas.toml", "--until", 1], ["bench", *TINY]):
                self.refuse(words, 2, "CAROM_SIMD", f"'{value}'", ", ".join(SIMD_NAMES), env=self.environment(value))

    def test_instructions_that_this_processor_lacks(self):
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            flags = set(file.read().split())
        for flag, name in (("sse4_2", "SSE4"), ("avx2", "AVX2"), ("avx512f", "AVX-512")):
            if flag not in flags:
                self.refuse(["bench", *TINY], 1, "CAROM_SIMD", name, "processor", env=self.environment(name))

    def test_empty_is_unset(self):
        self.json_of("bench", *TINY, env=self.environment(""))

    def test_help_mentions_it(self):
        for command in ("run", "bench"):
            self.assertIn("CAROM_SIMD=scalar|SSE4|AVX2|AVX-512", self.succeed(command, "--help").stdout)


# Prints 1000 collisions in `seconds`, and writes down how it was called.
FAKE = """#!/usr/bin/python3
import json, pathlib, sys
words = sys.argv[1:]
with open(pathlib.Path(__file__).with_suffix(".log"), "a") as log:
    print(*words, file=log)
{body}
"""
FAKE_OTHER = FAKE.format(body="""
shell = float(words[3])
if shell == 9:
    sys.exit("no shell of 9")
seconds = 0.002 + abs(shell - 0.7) / 1000  # best at 0.7
print(json.dumps({"disks": int(words[0]), "collisions": 1000, "seconds": seconds, "bytes_per_disk": 300}))
""")
FAKE_CAROM = FAKE.format(body="""
print(json.dumps({"benchmarks": [{"collisions": 1000, "seconds": 0.001, "bytes_per_disk": 200}]}))
""")


class Against(ProgramTest):
    """scripts/bench."""

    def program(self, name, text):
        self.write(name, text)
        self.path(name).chmod(0o755)
        return self.path(name)

    def script(self, *words):
        return subprocess.run([sys.executable, "-B", SOURCE / "scripts/bench", *map(str, words)], text=True,
                              capture_output=True, cwd=self.directory, timeout=100, check=False)

    def rows(self, *words):
        done = self.script(*words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [line.split() for line in done.stdout.splitlines()[1:]]

    def calls(self, name):
        return [line.split() for line in self.read(f"{name}.log").splitlines()]

    def test_ratio_is_that_of_the_times_at_the_best_shell(self):
        other, carom = self.program("other", FAKE_OTHER), self.program("carom", FAKE_CAROM)
        # 1000 collisions in 1 ms and in 2 ms; the other is best at a shell of 0.7, and refuses one of 9.
        self.assertEqual(self.rows("--against", other, "--carom", carom, "--shells", "2,0.7,0.5,9", "1e4", "0.70"),
                         [["10000", "0.7", "1000.0", "2000.0", "0.7", "2.00", "2.00", "..", "2.00", "200", "300"]])
        tried, timed = self.calls("other")[:4], self.calls("other")[4:]
        self.assertEqual([words[3] for words in tried], ["2", "0.7", "0.5", "9"])
        # A second of a million collisions: 200 for each of 10,000 disks.
        self.assertEqual(timed, [["10000", "0.7", "200", "0.7"]] * 5)
        self.assertEqual(self.calls("carom")[1:],
                         ["bench --disks 10000 --packing 0.7 --collisions-per-disk 200 --json".split()] * 5)

    def test_cases_in_their_order_with_so_many_pairs(self):
        other, carom = self.program("other", FAKE_OTHER), self.program("carom", FAKE_CAROM)
        rows = self.rows("--against", other, "--carom", carom, "--shells", "1", "--pairs", 2, "1e6", "0.2", "500", "0.5")
        self.assertEqual([row[:2] for row in rows], [["1000000", "0.2"], ["500", "0.5"]])
        self.assertEqual(len(self.calls("other")), 2 * (1 + 2))

    def test_with_carom_itself(self):
        other = self.program("other", FAKE_OTHER)
        ((disks, packing, ours, theirs, *_),) = self.rows("--against", other, "--carom", CAROM, "--shells", "0.7",
                                                          "--pairs", 2, "--seconds", "0.01", "100", "0.3")
        self.assertEqual((disks, packing, theirs), ("100", "0.3", "2000.0"))
        self.assertGreater(float(ours), 0)

    def refuse_script(self, words, code, *parts):
        done = self.script(*words)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)

    def test_what_cannot_be_compared_with(self):
        carom = self.program("carom", FAKE_CAROM)
        self.refuse_script(["--against", "nowhere", "--carom", carom], 1, "nowhere: there is no such program")
        self.refuse_script(["--against", carom, "--carom", "nowhere"], 1, "nowhere: there is no such program")
        for name, body, *parts in (("silent", "", "nothing"), ("words", "print('fast')", "fast"),
                                   ("list", "print([1])", "[1]"), ("fails", "sys.exit('sorry')", "code 1", "sorry"),
                                   ("none", "print('{\"collisions\": 5}')", "'seconds'"),
                                   ("zero", "print('{\"collisions\": 0, \"seconds\": 1}')", "'collisions'"),
                                   ("nan", "print('{\"collisions\": 5, \"seconds\": NaN}')", "'seconds'")):
            with self.subTest(name=name):
                other = self.program(name, FAKE.format(body=body))
                self.refuse_script(["--against", other, "--carom", carom, "100", "0.3"], 1, name, *parts)

    def test_usage(self):
        other = self.program("other", FAKE_OTHER)
        for words in ([], ["1e4", "0.7"], ["--against", other, "1e4"], ["--against", other, "1e4", "x"],
                      ["--against", other, "--pairs", "0"], ["--against", other, "--shells", "1,-1"],
                      ["--against", other, "1.5", "0.3"]):
            self.refuse_script(words, 2, "usage:")
        self.assertIn("--against", self.script("--help").stdout)


if __name__ == "__main__":
    main()
