// Property: validate() finds everything that makes a system impossible to simulate, names it, and finds nothing else.
#include "carom/state/validate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "carom/base/random.hpp"
#include "make_system.hpp"

namespace carom {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Finding> validate(const TestSystem& test) { return carom::validate(test.system, test.frame); }

/// Expects one finding with this text.
void expect_finding(const TestSystem& test, std::string_view message, std::optional<std::size_t> disk = {},
                    Finding::About about = Finding::About::disks) {
  const std::vector<Finding> findings = validate(test);
  ASSERT_EQ(findings.size(), 1u) << (findings.empty() ? "" : findings[0].message);
  EXPECT_NE(findings[0].message.find(message), std::string::npos) << findings[0].message;
  EXPECT_EQ(findings[0].disk, disk);
  EXPECT_EQ(findings[0].about, about);
}

const Box kBox{.size = {10, 10}, .boundary = kPeriodic};
const Box kWalls{.size = {10, 10}, .boundary = kReflecting};

TEST(Validate, NothingWrong) {
  EXPECT_TRUE(validate(TestSystem(kBox, {{{0, 0}}, {{5, 5}}})).empty());
  EXPECT_TRUE(validate(TestSystem(kWalls, {{{0.5, 9.5}}, {{5, 5}}})).empty()) << "touching walls";
  EXPECT_TRUE(validate(TestSystem(kBox, {{{1, 1}}, {{2, 1}}, {{2, 2}}})).empty()) << "touching disks";
  EXPECT_TRUE(validate(TestSystem({.size = {0, 0}, .boundary = kOpen}, {{{-1e9, 7}}})).empty()) << "open plane";
}

TEST(Validate, NoDisks) { expect_finding(TestSystem(kBox), "there are no disks"); }

TEST(Validate, Box) {
  const auto expect = [](Vec2 size, std::string_view message) {
    expect_finding(TestSystem({.size = size, .boundary = kReflecting}, {{{5, 5}}}), message, {}, Finding::About::box);
  };
  expect({kNan, 10}, "the box's width is nan: it must be a finite number");
  expect({kInfinity, 10}, "must be a finite number");
  expect({0, 10}, "the box's width is 0: it must be greater than 0");
  expect({10, -3}, "the box's height is -3: it must be greater than 0");
  expect({10, 1e80}, "too large");
  expect({10, 1e-80}, "too small");
}

TEST(Validate, Physics) {
  const auto expect = [](auto set, std::string_view message) {
    TestSystem test(kBox, {{{5, 5}}});
    set(test.system.physics);
    expect_finding(test, message, {}, Finding::About::physics);
  };
  expect([](Physics& p) { p.restitution = 1.01; }, "restitution is 1.01: it must lie in [0, 1]");
  expect([](Physics& p) { p.restitution = -0.5; }, "restitution is -0.5");
  expect([](Physics& p) { p.restitution = kNan; }, "restitution is nan");
  expect([](Physics& p) { p.wall_restitution = 2; }, "wall_restitution is 2: it must lie in [0, 1]");
  expect([](Physics& p) { p.t_c = -1; }, "t_c is -1");
  expect([](Physics& p) { p.t_c = kInfinity; }, "t_c is inf");
}

TEST(Validate, NumbersOfDisks) {
  const auto expect = [](const TestDisk& disk, std::string_view message) {
    expect_finding(TestSystem(kBox, {{{8, 8}}, disk}), message, 1);
  };
  expect({{5, 5}, 0}, "radius of disk 1 is 0: it must be greater than 0");
  expect({{5, 5}, -0.5}, "radius of disk 1 is -0.5");
  expect({{5, 5}, kNan}, "radius of disk 1 is nan: it must be a finite number");
  expect({{5, 5}, kInfinity}, "radius of disk 1 is inf");
  expect({{5, 5}, 1e-80}, "radius of disk 1 is 1e-80: it is too small");
  expect({{5, 5}, 0.5, {}, 0}, "mass of disk 1 is 0: it must be greater than 0");
  expect({{5, 5}, 0.5, {}, kNan}, "mass of disk 1 is nan");
  expect({{kNan, 5}}, "x of disk 1 is nan");
  expect({{5, -kInfinity}}, "y of disk 1 is -inf: it must be a finite number");
  expect({{5, 5}, 0.5, {kNan, 0}}, "vx of disk 1 is nan");
  expect({{5, 5}, 0.5, {0, 1e80}}, "vy of disk 1 is 1e+80: it is too large");
}

TEST(Validate, SeveralThingsAtOnce) {
  TestSystem test({.size = {0, 10}, .boundary = kReflecting}, {{{5, 5}, -1}, {{kNan, 5}, 0.5, {}, 0}});
  test.system.physics.restitution = 7;
  EXPECT_EQ(validate(test).size(), 5u);
}

TEST(Validate, OutsideTheBox) {
  expect_finding(TestSystem(kWalls, {{{5, 5}}, {{0.25, 5}}}),
                 "disk 1 is outside the box: it reaches 0.25 past the left wall", 1);
  expect_finding(TestSystem(kWalls, {{{9.75, 5}}}), "past the right wall", 0);
  expect_finding(TestSystem(kWalls, {{{5, 0.25}}}), "past the bottom wall", 0);
  expect_finding(TestSystem(kWalls, {{{5, 12}}}), "reaches 2.5 past the top wall", 0);
  expect_finding(TestSystem(kBox, {{{-1, 5}}}), "reaches 1 past the left edge", 0);
  expect_finding(TestSystem(kBox, {{{5, 11}}}), "reaches 1 past the top edge", 0);
  EXPECT_TRUE(validate(TestSystem(kBox, {{{10, 0}}})).empty()) << "the seam belongs to the box";
}

TEST(Validate, ToleratesABillionthOfARadiusAtWalls) {
  EXPECT_TRUE(validate(TestSystem(kWalls, {{{0.5 - 0.4e-9, 5}}})).empty());
  EXPECT_FALSE(validate(TestSystem(kWalls, {{{0.5 - 0.6e-9, 5}}})).empty());
  EXPECT_TRUE(validate(TestSystem(kBox, {{{-0.4e-9, 5}}})).empty());
  EXPECT_FALSE(validate(TestSystem(kBox, {{{-0.6e-9, 5}}})).empty());
}

TEST(Validate, NarrowPeriodicBox) {
  expect_finding(TestSystem({.size = {0.9, 10}, .boundary = kPeriodic}, {{{0.5, 5}}}),
                 "the periodic box is 0.9 wide, narrower than the largest disk's diameter 1", {}, Finding::About::box);
  expect_finding(TestSystem({.size = {10, 5}, .boundary = kPeriodic}, {{{0.5, 1}}, {{5, 2.5}, 3}}),
                 "5 high, narrower than the largest disk's diameter 6", {}, Finding::About::box);
  EXPECT_TRUE(validate(TestSystem({.size = {1, 1}, .boundary = kPeriodic}, {{{0.5, 0.5}}})).empty())
      << "touching itself";
}

TEST(Validate, OverlapsNameBothDisks) {
  expect_finding(TestSystem(kBox, {{{8, 8}}, {{5, 5}}, {{5.75, 5}}}),
                 "disk 1 and disk 2 overlap by 0.25 (contact distance 1)", 2);
  expect_finding(TestSystem(kBox, {{{5, 5}}, {{5, 5}}}), "disk 0 and disk 1 have the same centre", 1);
  expect_finding(TestSystem(kBox, {{{0.25, 5}}, {{9.75, 5}}}), "disk 0 and disk 1 overlap by 0.5", 1);
  expect_finding(TestSystem(kBox, {{{0.25, 0.25}}, {{9.75, 9.75}}}), "disk 0 and disk 1 overlap by 0.293", 1);
  EXPECT_TRUE(validate(TestSystem(kWalls, {{{0.75, 5}}, {{9.25, 5}}})).empty()) << "no seam at walls";
}

TEST(Validate, ToleratesABillionthOfTheContactDistance) {
  EXPECT_TRUE(validate(TestSystem(kBox, {{{5, 5}}, {{6 - 0.9e-9, 5}}})).empty());
  EXPECT_FALSE(validate(TestSystem(kBox, {{{5, 5}}, {{6 - 1.1e-9, 5}}})).empty());
}

TEST(Validate, PairThatOverlapsThroughTwoImagesIsOneFinding) {
  // In a box 1.5 wide two disks side by side overlap on both sides: by 0.3 and by 0.2.
  expect_finding(TestSystem({.size = {1.5, 10}, .boundary = kPeriodic}, {{{0.2, 5}}, {{0.9, 5}}}),
                 "disk 0 and disk 1 overlap by 0.3 ", 1);
}

TEST(Validate, HundredfoldSizes) {
  TestSystem test({.size = {300, 300}, .boundary = kPeriodic}, {{{10, 150}, 100}});
  test.add({{109, 150}, 1});    // inside the rim by 2
  test.add({{111.5, 150}, 1});  // outside
  test.add({{211, 150}, 1});    // overlaps through the seam: 10 + 300 − 211 = 99
  test.add({{208, 150}, 1});    // clear of everything
  const std::vector<Finding> findings = validate(test);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].message, "disk 0 and disk 1 overlap by 2 (contact distance 101)");
  EXPECT_EQ(findings[1].message, "disk 0 and disk 3 overlap by 2 (contact distance 101)");
}

TEST(Validate, ListsTwentyOfAKindAndCountsTheRest) {
  TestSystem test(kWalls);
  for (int k = 0; k < 27; ++k) test.add({{-1.0 - k, 5}});
  const std::vector<Finding> findings = validate(test);
  ASSERT_EQ(findings.size(), 21u);
  EXPECT_EQ(findings.back().message, "… and 7 more disks outside the box");
  EXPECT_FALSE(findings.back().disk);
}

TEST(Validate, DisksInAHeapAreNotCountedWithoutEnd) {
  TestSystem test(kWalls);
  for (int k = 0; k < 200'000; ++k) test.add({{5, 5}});  // 2·10¹⁰ pairs
  const std::vector<Finding> findings = validate(test);
  ASSERT_EQ(findings.size(), 21u);
  EXPECT_EQ(findings.back().message.rfind("… and at least ", 0), 0u) << findings.back().message;
}

// --- against a search of all pairs and images ---------------------------------------------------------------------

using PairSet = std::set<std::pair<std::size_t, std::size_t>>;

PairSet overlaps_by_brute_force(const TestSystem& test) {
  PairSet pairs;
  const Box& box = test.system.box;
  const int nx = box.periodic(0) ? 2 : 0;
  const int ny = box.periodic(1) ? 2 : 0;
  for (std::size_t i = 0; i < test.frame.size(); ++i) {
    for (std::size_t j = i + 1; j < test.frame.size(); ++j) {
      const double sigma = test.system.radius(i) + test.system.radius(j);
      for (int a = -nx; a <= nx; ++a) {
        for (int b = -ny; b <= ny; ++b) {
          const Vec2 image{a * box.size.x, b * box.size.y};
          if (length(test.frame.position(j) + image - test.frame.position(i)) < sigma) pairs.insert({i, j});
        }
      }
    }
  }
  return pairs;
}

PairSet overlaps_found(const TestSystem& test) {
  PairSet pairs;
  for (const Finding& finding : validate(test)) {
    std::size_t i = 0, j = 0;
    EXPECT_EQ(std::sscanf(finding.message.c_str(), "disk %zu and disk %zu overlap", &i, &j), 2) << finding.message;
    EXPECT_EQ(finding.disk, j);
    EXPECT_TRUE(pairs.insert({i, j}).second) << "named twice: " << finding.message;
  }
  return pairs;
}

TestSystem random_system(RandomStream& random) {
  constexpr std::array kBoundaries{kPeriodic, kReflecting, kOpen, kMixed};
  const Box box{.size = {1 + 9 * random.uniform(), 1 + 9 * random.uniform()}, .boundary = kBoundaries[random.below(4)]};
  TestSystem test(box);
  const double largest = 0.5 * std::min(box.size.x, box.size.y);
  const std::uint64_t disks = 2 + random.below(20);
  for (std::uint64_t k = 0; k < disks; ++k) {
    const double radius = largest * std::exp2(-8 * random.uniform());
    const double x = box.reflecting(0) ? radius : 0;
    const double y = box.reflecting(1) ? radius : 0;
    test.add({{x + (box.size.x - 2 * x) * random.uniform(), y + (box.size.y - 2 * y) * random.uniform()}, radius});
  }
  return test;
}

TEST(Validate, FindsTheOverlapsOfABruteForceSearch) {
  RandomStream random(3, 0, 0);
  int with_overlaps = 0, without = 0;
  for (int k = 0; k < 1000; ++k) {
    const TestSystem test = random_system(random);
    const PairSet expected = overlaps_by_brute_force(test);
    if (expected.size() > 20) continue;  // not all would be listed
    ASSERT_EQ(overlaps_found(test), expected) << "system " << k;
    (expected.empty() ? without : with_overlaps) += 1;
  }
  EXPECT_GT(with_overlaps, 200);
  EXPECT_GT(without, 50);
}

}  // namespace
}  // namespace carom
