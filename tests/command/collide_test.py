"""`carom collide` prints, explains and draws the outcome of one collision, or of a table of them, and refuses what is
no collision with one line and the right exit code."""

import csv
import io
import itertools
import math

from program import ProgramTest, main

KEYS = """approaching normal tangent v1n v1t v2n v2t v1n_after v2n_after velocity1_after velocity2_after
momentum_before momentum_after energy_before energy_after impulse equal_masses time_of_contact position1
position2""".split()
HEADER = "x1,y1,vx1,vy1,m1,x2,y2,vx2,vy2,m2"


def disks(first, second):
    return ["--disk", first, "--disk", second]


class OneCollision(ProgramTest):
    def test_all_keys_are_there(self):
        result = self.json_of("collide", *disks("0,0,1,0", "1,0,0,0"))
        self.assertEqual(sorted(result), sorted(KEYS))

    def test_equal_masses_head_on_exchange_velocities(self):
        result = self.json_of("collide", *disks("0,0,1,0", "1,0,0,0"))
        self.assertEqual(result["velocity1_after"], [0, 0])
        self.assertEqual(result["velocity2_after"], [1, 0])
        self.assertEqual(result["normal"], [1, 0])
        self.assertEqual(result["tangent"], [0, 1])
        self.assertEqual((result["v1n"], result["v1t"], result["v2n"], result["v2t"]), (1, 0, 0, 0))
        self.assertEqual((result["v1n_after"], result["v2n_after"]), (0, 1))
        self.assertEqual(result["impulse"], [1, 0])
        self.assertEqual((result["energy_before"], result["energy_after"]), (0.5, 0.5))
        self.assertEqual((result["momentum_before"], result["momentum_after"]), ([1, 0], [1, 0]))
        self.assertIs(result["equal_masses"], True)
        self.assertIs(result["approaching"], True)
        self.assertEqual(result["time_of_contact"], 0)
        self.assertEqual((result["position1"], result["position2"]), ([0, 0], [1, 0]))

    def test_unequal_masses_conserve_momentum_and_energy(self):
        result = self.json_of("collide", *disks("0,0,2,1,3", "1,1,-1,0.5,1.5"))
        self.assertIs(result["equal_masses"], False)
        for before, after in zip(result["momentum_before"], result["momentum_after"]):
            self.assertLessEqual(abs(after - before), 1e-15 * abs(before))
        self.assertLessEqual(abs(result["energy_after"] / result["energy_before"] - 1), 1e-15)
        # By hand: n = (1,1)/√2, approach speed (3 + 0.5)/√2, J = 2 μ × that along n with μ = 1.
        self.assertAlmostEqual(result["velocity1_after"][0], 2 - 3.5 / 3, delta=1e-15)
        self.assertAlmostEqual(result["velocity1_after"][1], 1 - 3.5 / 3, delta=1e-15)
        self.assertAlmostEqual(result["velocity2_after"][0], -1 + 3.5 / 1.5, delta=1e-15)

    def test_numbers_are_read_to_the_nearest_double(self):
        # Via an 80-bit long double this decimal would round twice, to 1.
        result = self.json_of("collide", *disks("0,0,1.00000000000000011103,0", "1,0,0,0"))
        self.assertEqual(result["v1n"], float("1.00000000000000011103"))

    def test_restitution(self):
        result = self.json_of("collide", *disks("0,0,1,0", "1,0,-1,0"), "--restitution", "0.5")
        self.assertEqual(result["v2n_after"] - result["v1n_after"], 1)
        stuck = self.json_of("collide", *disks("0,0,1,0", "1,0,-1,0"), "--restitution", "0")
        self.assertEqual(stuck["v2n_after"], stuck["v1n_after"])
        for e in ("-0.1", "1.1", "nan", "x", ""):
            self.refuse(["collide", *disks("0,0,1,0", "1,0,0,0"), "--restitution", e], 2 if e in ("nan", "x", "") else 1,
                        "--restitution")

    def test_disks_that_part_do_not_collide(self):
        words = ["collide", *disks("0,0,-1,0.5", "1,0,1,0")]
        result = self.json_of(*words)
        self.assertIs(result["approaching"], False)
        self.assertEqual((result["velocity1_after"], result["velocity2_after"]), ([-1, 0.5], [1, 0]))
        self.assertEqual(result["impulse"], [0, 0])
        self.assertIn("do not collide", self.succeed(*words).stdout)

    def test_plain_text_tells_the_outcome(self):
        text = self.succeed("collide", *disks("0,0,1,0", "1,0,0,0")).stdout
        self.assertIn("disk 1: velocity ⟨1, 0⟩ before, ⟨0, 0⟩ after", text)

    def test_options_in_any_order_and_form(self):
        groups = [["--disk", "-1,-.5,1,0"], ["--disk=0,0,0,0"], ["--json"], ["--restitution=1"]]
        outputs = {self.succeed("collide", *itertools.chain(*order)).stdout
                   for order in itertools.permutations(groups) if order.index(groups[0]) < order.index(groups[1])}
        self.assertEqual(len(outputs), 1)

    def test_blanks_beside_commas(self):
        self.assertEqual(self.json_of("collide", *disks("0, 0, 1, 0", " 1,0 ,0,0"))["velocity2_after"], [1, 0])

    def test_signs_exponents_and_bare_points(self):
        result = self.json_of("collide", *disks("-1,-.5,0,0", "+1e0,5.E-1,-2,-1"))
        self.assertEqual(result["position1"], [-1, -0.5])
        self.assertEqual(result["position2"], [1, 0.5])


class Contact(ProgramTest):
    def test_advance_moves_to_the_first_contact(self):
        result = self.json_of("collide", *disks("-3,0,1,0,1,0.5", "0.6,0.8,0,0,1,0.5"), "--advance")
        self.assertAlmostEqual(result["time_of_contact"], 3, delta=1e-14)
        self.assertAlmostEqual(result["position1"][0], 0, delta=1e-14)
        self.assertEqual(result["position2"], [0.6, 0.8])
        for got, wanted in zip(result["velocity1_after"] + result["velocity2_after"], [0.64, -0.48, 0.36, 0.48]):
            self.assertAlmostEqual(got, wanted, delta=1e-14)

    def test_advance_without_a_contact(self):
        self.refuse(["collide", *disks("-3,0,1,0,1,0.5", "0,1.5,0,0,1,0.5"), "--advance"], 1, "never touch")
        self.refuse(["collide", *disks("-3,0,-1,0,1,0.5", "0,0,0,0,1,0.5"), "--advance", "--json"], 1, "never touch")

    def test_advance_leaves_disks_in_contact_where_they_stand(self):
        for velocity, approaching in ((1, True), (-1, False)):
            result = self.json_of("collide", *disks(f"0,0,{velocity},0,1,0.5", "0.9,0,0,0,1,0.5"), "--advance")
            self.assertEqual((result["time_of_contact"], result["position1"]), (0, [0, 0]))
            self.assertIs(result["approaching"], approaching)

    def test_advance_needs_radii(self):
        self.refuse(["collide", *disks("-3,0,1,0", "0,0,0,0"), "--advance"], 2, "radii")

    def test_radii_touching_or_overlapping_are_in_contact(self):
        for x in (1, 0.9, 1 + 1e-12):
            result = self.json_of("collide", *disks("0,0,1,0,1,0.5", f"{x},0,0,0,1,0.5"))
            self.assertEqual(result["velocity2_after"], [1, 0])

    def test_radii_apart_are_not(self):
        self.refuse(["collide", *disks("0,0,1,0,1,0.5", "1.5,0,0,0,1,0.5")], 1, "0.5 apart", "--advance")

    def test_both_radii_or_neither(self):
        self.refuse(["collide", *disks("0,0,1,0,1,0.5", "1,0,0,0")], 2, "radius")

    def test_same_centre(self):
        for more in ([], ["--json"], ["--explain"], ["--svg", "x.svg"]):
            self.refuse(["collide", *disks("1,1,1,0", "1,1,0,0"), *more], 1, "same centre")
        self.assertFalse(self.path("x.svg").exists())
        self.refuse(["collide", *disks("1,1,1,0,1,1", "1,1,0,0,1,1"), "--advance"], 1, "same centre")


class Explanation(ProgramTest):
    WORDS = ["collide", *disks("0,0,1,0", "0.6,0.8,0,0"), "--explain"]

    def test_three_formats_hold_the_equations(self):
        text = self.succeed(*self.WORDS).stdout
        self.assertEqual(self.succeed(*self.WORDS, "--format", "text").stdout, text)
        markdown = self.succeed(*self.WORDS, "--format", "markdown").stdout
        latex = self.succeed(*self.WORDS, "--format=latex").stdout
        for document in (text, markdown, latex):
            for number in ("0.36", "0.48", "0.64"):
                self.assertIn(number, document)
            for label in "123456ABCD":
                self.assertRegex(document, rf"\({label}[),]|\({label}\b|tag\{{{label}")
        self.assertIn("$$", markdown)
        self.assertIn(r"\begin{document}", latex)

    def test_format_needs_explain(self):
        self.refuse(["collide", *disks("0,0,1,0", "1,0,0,0"), "--format", "latex"], 2, "--explain")
        self.refuse([*self.WORDS, "--format", "html"], 2, "--format", "html", "latex")

    def test_json_and_explain_exclude_each_other(self):
        self.refuse([*self.WORDS, "--json"], 2, "--explain", "--json")


class Drawing(ProgramTest):
    WORDS = ["collide", *disks("0,0,1,0,1,0.5", "0.6,0.8,0,0,1,0.5")]

    def test_pictures_by_ending(self):
        for name, start in (("a.svg", b"<?xml"), ("a.png", b"\x89PNG"), ("a.pdf", b"%PDF")):
            self.succeed(*self.WORDS, "--svg", name)
            self.assertTrue(self.path(name).read_bytes().startswith(start), name)
        self.assertIn(b"</svg>", self.path("a.svg").read_bytes())

    def test_json_goes_with_it(self):
        self.json_of(*self.WORDS, "--svg", "a.svg")

    def test_unknown_ending_and_missing_directory(self):
        self.refuse([*self.WORDS, "--svg", "a.bmp"], 1, "a.bmp", ".svg")
        self.refuse([*self.WORDS, "--svg", "nowhere/a.svg"], 1, "nowhere/a.svg", "No such file")


class Batch(ProgramTest):
    TABLE = f"{HEADER}\n0,0,1,0,1,1,0,0,0,1\n0,0,2,1,3,1,1,-1,0.5,1.5\n"

    def rows(self, text):
        return list(csv.DictReader(io.StringIO(text)))

    def test_rows_agree_with_single_collisions(self):
        self.write("pairs.csv", self.TABLE)
        from_file = self.succeed("collide", "--batch", "pairs.csv").stdout
        self.assertEqual(self.succeed("collide", "--batch", "-", stdin=self.TABLE).stdout, from_file)
        self.assertEqual(from_file.splitlines()[0], HEADER + ",vx1_after,vy1_after,vx2_after,vy2_after")
        for row in self.rows(from_file):
            single = self.json_of("collide", *disks(
                *(",".join(row[k + i] for k in ("x", "y", "vx", "vy", "m")) for i in "12")))
            for i in "12":
                after = [float(row[f"vx{i}_after"]), float(row[f"vy{i}_after"])]
                self.assertEqual(after, single[f"velocity{i}_after"])

    def test_columns_in_any_order(self):
        names = HEADER.split(",")[::-1]
        table = ",".join(names) + "\n" + ",".join(["1", "0", "0", "0", "1", "1", "0", "1", "0", "0"]) + "\n"
        (row,) = self.rows(self.succeed("collide", "--batch", "-", stdin=table).stdout)
        self.assertEqual([float(row[k]) for k in ("vx1_after", "vx2_after")], [0, 1])

    def test_restitution_applies(self):
        (row,) = self.rows(self.succeed("collide", "--batch", "-", "--restitution", "0",
                                        stdin=f"{HEADER}\n0,0,1,0,1,1,0,0,0,1\n").stdout)
        self.assertEqual([float(row[k]) for k in ("vx1_after", "vx2_after")], [0.5, 0.5])

    def test_bad_rows_are_all_named(self):
        self.write("bad.csv", f"{HEADER}\n0,0,1,0,0,1,0,0,0,1\n0,0,x,0,1,1,0,0,0,1\n1,2\n0,0,1,0,1,0,0,0,0,1\n")
        done = self.refuse(["collide", "--batch", "bad.csv"], 1, "bad.csv:2:9:", "bad.csv:3:5:", "bad.csv:4:1:",
                           "bad.csv:5:1:", "same centre")
        self.assertEqual(len(done.stderr.splitlines()), 4)

    def test_bad_tables(self):
        self.refuse(["collide", "--batch", "nowhere.csv"], 1, "nowhere.csv", "No such file")
        self.refuse(["collide", "--batch", "-"], 1, "<stdin>", "header")
        self.refuse(["collide", "--batch", "-"], 1, "<stdin>:1", "vy2", stdin="x1,y1,vx1,vy1,m1,x2,y2,vx2,m2\n")
        self.refuse(["collide", "--batch", "-", "--json"], 2, "--batch")


class Refusals(ProgramTest):
    def test_usage_errors(self):
        good = disks("0,0,1,0", "1,0,0,0")
        for words, part in (
                ([], "--disk"), (good[:2], "--disk"), ([*good, "--disk", "3,3,0,0"], "--disk"),
                (disks("0,0,1", "1,0,0,0"), "0,0,1:"), (disks("0,0,1,0,1,1,1", "1,0,0,0"), "instead of 7"),
                (disks("0,0,1,zero", "1,0,0,0"), "'zero'"), (disks("0,0,1,0x", "1,0,0,0"), "'0x'"),
                (disks("0,0,nan,0", "1,0,0,0"), "'nan'"), (disks("0,0,1e400,0", "1,0,0,0"), "'1e400'"),
                (disks("0,0,1,", "1,0,0,0"), "''"), (disks("", "1,0,0,0"), "--disk"),
                ([*good, "--frobnicate"], "--frobnicate"), ([*good, "extra"], "extra"), (["--disk"], "--disk")):
            with self.subTest(words=words):
                self.assertEqual(len(self.refuse(["collide", *words], 2, part).stderr.splitlines()), 1)

    def test_bad_values(self):
        for first, part in (("0,0,1,0,0", "mass"), ("0,0,1,0,-1", "mass"), ("0,0,1,0,1,0", "radius"),
                            ("0,0,1,0,1,-2", "radius"), ("1e300,0,1,0", "too large"), ("0,0,1,0,1e-300", "too small")):
            with self.subTest(first=first):
                done = self.refuse(["collide", *disks(first, "1,0,0,0,1,1" if first.count(",") == 5 else "1,0,0,0")],
                                   1, part)
                self.assertEqual(len(done.stderr.splitlines()), 1)

    def test_extreme_but_possible_values_stay_finite(self):
        result = self.json_of("collide", *disks("0,0,1e70,0,1e70", "1e70,0,-1e70,0,1e-70"))
        for value in itertools.chain(result["velocity1_after"], result["velocity2_after"], result["impulse"]):
            self.assertTrue(math.isfinite(value))


if __name__ == "__main__":
    main()
