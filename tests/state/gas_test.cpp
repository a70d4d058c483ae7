// Property: places for a gas are free and inside; what a start says can be placed can be placed; velocities have the
// temperature asked for and no total momentum.
#include "carom/state/gas.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "carom/base/random.hpp"
#include "carom/state/validate.hpp"
#include "make_system.hpp"

namespace carom {
namespace {

constexpr std::array<std::array<Boundary, 2>, 5> kAllBoundaries{kPeriodic, kReflecting, kOpen, kMixed,
                                                                std::array{Boundary::reflecting, Boundary::periodic}};

/// Places and obstacles as a system.
TestSystem system_of(const Box& box, const std::vector<Vec2>& positions, double radius,
                     const std::vector<Obstacle>& obstacles = {}) {
  TestSystem test(box);
  for (const Obstacle& obstacle : obstacles) test.add({obstacle.position, obstacle.radius});
  for (const Vec2 position : positions) test.add({position, radius});
  return test;
}

std::string problems(const TestSystem& test) {
  std::string text;
  for (const Finding& finding : validate(test.system, test.frame)) text += finding.message + "\n";
  return text;
}

Box box_for(std::size_t count, double radius, double packing, double aspect, std::array<Boundary, 2> boundary) {
  const double width = std::sqrt(static_cast<double>(count) * kPi * radius * radius / packing / aspect);
  return {.size = {width, width * aspect}, .boundary = boundary};
}

TEST(Lattice, EveryNumberOfDisksIsFreeAndInside) {
  constexpr double kRadius = 0.5;
  int placed = 0, refused = 0;
  for (std::size_t count = 1; count <= 300; ++count) {
    for (const double aspect : {0.1, 0.75, 0.8660254037844386, 1.0, 3.0}) {
      for (const auto& boundary : kAllBoundaries) {
        for (const double packing : {0.05, 0.5, 0.8}) {
          const Box box = box_for(count, kRadius, packing, aspect, boundary);
          const Placement placement = place_on_lattice(box, count, kRadius, {});
          const bool all = placement.positions.size() == count;
          (all ? placed : refused) += 1;
          ASSERT_EQ(all, placement.room >= 1) << count << " disks, aspect " << aspect << ", packing " << packing;
          if (placement.positions.empty()) continue;
          ASSERT_EQ(problems(system_of(box, placement.positions, kRadius)), "")
              << count << " disks, aspect " << aspect << ", packing " << packing;
        }
      }
    }
  }
  EXPECT_GT(placed, 12'000);
  EXPECT_GT(refused, 100) << "small closed boxes cannot take 0.8";
}

TEST(Lattice, RoomIsWhatTheRadiiCanGrowBy) {
  for (const std::size_t count : {1u, 2u, 3u, 7u, 16u, 50u, 101u}) {
    for (const auto& boundary : kAllBoundaries) {
      for (const double packing : {0.3, 0.7, 1.1}) {
        const Box box = box_for(count, 0.5, packing, 1, boundary);
        const double room = place_on_lattice(box, count, 0.5, {}).room;
        ASSERT_GT(room, 0);
        const double radius = 0.5 * room * (1 - 1e-9);
        const Placement tight = place_on_lattice(box, count, radius, {});
        ASSERT_EQ(tight.positions.size(), count) << count << " disks at " << packing;
        ASSERT_EQ(problems(system_of(box, tight.positions, radius)), "");
      }
    }
  }
}

TEST(Lattice, PlacesAsManyAsItCan) {
  RandomStream random(1, 0, 0);
  for (int k = 0; k < 300; ++k) {
    const Box box{.size = {1 + 12 * random.uniform(), 1 + 12 * random.uniform()},
                  .boundary = kAllBoundaries[random.below(5)]};
    const std::size_t most = place_on_lattice(box, 500, 0.5, {}).positions.size();
    ASSERT_LT(most, 500u);
    ASSERT_GE(most, 1u) << "a box of 1 × 1 holds one";
    ASSERT_EQ(place_on_lattice(box, most, 0.5, {}).positions.size(), most);
    ASSERT_LT(place_on_lattice(box, most + 1, 0.5, {}).positions.size(), most + 1);
  }
}

TEST(Lattice, ReachesTheClosestPacking) {
  // 10 × 10 disks of a triangular lattice, hair's breadth apart.
  Box box{.size = {10, 10 * std::sqrt(3.0) / 2}, .boundary = kPeriodic};
  const double radius = 0.5 * (1 - 1e-12);
  const Placement placement = place_on_lattice(box, 100, radius, {});
  EXPECT_EQ(placement.positions.size(), 100u);
  EXPECT_EQ(problems(system_of(box, placement.positions, radius)), "");
  EXPECT_TRUE(place_on_lattice(box, 101, radius, {}).positions.size() == 100);
}

// Boxes narrower than a disk once let a lattice through whose sites lie outside.
TEST(Lattice, RefusesBoxesThatHoldNoDisk) {
  for (const Vec2 size : {Vec2{0.9, 10}, Vec2{10, 0.9}, Vec2{0.5, 0.5}}) {
    for (const auto& boundary : {kReflecting, kOpen}) {
      for (const std::size_t count : {1u, 2u, 5u}) {
        EXPECT_TRUE(place_on_lattice({.size = size, .boundary = boundary}, count, 0.5, {}).positions.empty());
      }
    }
  }
}

TEST(Lattice, StaysInsideVeryWideBoxes) {
  // The last digit of such a width is larger than the tolerance at walls.
  for (std::size_t count = 2; count <= 60; ++count) {
    const Box box{.size = {1e9 / 3, 1e8 / 7}, .boundary = kReflecting};
    const Placement placement = place_on_lattice(box, count, 0.5, {});
    ASSERT_EQ(problems(system_of(box, placement.positions, 0.5)), "") << count;
  }
}

TEST(Lattice, GoesAroundObstacles) {
  RandomStream random(2, 0, 0);
  int placed = 0;
  for (int k = 0; k < 300; ++k) {
    const Box box{.size = {20, 15}, .boundary = kAllBoundaries[random.below(5)]};
    const std::vector<Obstacle> obstacles{
        {{3 + 4 * random.uniform(), 3 + 9 * random.uniform()}, 3},
        {{13 + 4 * random.uniform(), 3 + 9 * random.uniform()}, 3 * random.uniform()}};
    const std::size_t count = 1 + random.below(300);
    const Placement placement = place_on_lattice(box, count, 0.5, obstacles);
    placed += placement.positions.size() == count;
    ASSERT_FALSE(placement.positions.empty());
    ASSERT_EQ(problems(system_of(box, placement.positions, 0.5, obstacles)), "");
    ASSERT_EQ(place_on_lattice(box, placement.positions.size(), 0.5, obstacles).positions.size(),
              placement.positions.size())
        << "what it says can be placed can be placed";
  }
  EXPECT_GT(placed, 100);
  EXPECT_LT(placed, 290);
}

TEST(Lattice, AroundObstaclesRefusesBoxesThatHoldNoDisk) {
  const std::vector<Obstacle> obstacles{{{5, 0.4}, 0.25}};
  EXPECT_TRUE(place_on_lattice({.size = {10, 0.9}, .boundary = kReflecting}, 3, 0.5, obstacles).positions.empty());
}

TEST(Lattice, UnderAnObstacleThatCoversTheBoxPlacesNone) {
  const std::vector<Obstacle> all{{{5, 5}, 7.2}};
  EXPECT_TRUE(place_on_lattice({.size = {10, 10}, .boundary = kOpen}, 3, 0.5, all).positions.empty());
}

// --- random start -------------------------------------------------------------------------------------------------

TEST(RandomStart, IsFreeAndInside) {
  RandomStream random(4, 0, 0);
  for (int k = 0; k < 60; ++k) {
    const Box box{.size = {10 + 10 * random.uniform(), 10}, .boundary = kAllBoundaries[random.below(5)]};
    const std::vector<Obstacle> obstacles{{{5, 5}, 2}};
    std::vector<double> radii;
    for (int n = 0; n < 40; ++n) radii.push_back(0.1 + 0.5 * random.uniform());
    const Placement placement = place_at_random(box, radii, static_cast<std::uint64_t>(k), obstacles);
    ASSERT_EQ(placement.positions.size(), radii.size());
    TestSystem test(box, {{{5, 5}, 2}});
    for (std::size_t n = 0; n < radii.size(); ++n) test.add({placement.positions[n], radii[n]});
    ASSERT_EQ(problems(test), "");
  }
}

TEST(RandomStart, FillsTheBoxEvenly) {
  const std::vector<double> radii(20'000, 0.001);
  const Placement placement = place_at_random({.size = {1, 1}, .boundary = kPeriodic}, radii, 5, {});
  ASSERT_EQ(placement.positions.size(), radii.size());
  std::array<double, 16> hits{};
  for (const Vec2 p : placement.positions)
    ++hits[4 * static_cast<std::size_t>(4 * p.x) + static_cast<std::size_t>(4 * p.y)];
  for (const double hit : hits) EXPECT_NEAR(hit, 1250, 5 * std::sqrt(1250.0));
}

TEST(RandomStart, GivesUpWhereThereIsNoPlace) {
  const std::vector<double> radii(100, 0.5);
  const Box box{.size = {10, 10}, .boundary = kReflecting};
  const Placement placement = place_at_random(box, radii, 6, {});
  const std::size_t placed = placement.positions.size();
  EXPECT_GT(placed, 50u);
  EXPECT_LT(placed, 75u) << "random sequential addition jams at a packing fraction of 0.547";
  EXPECT_EQ(problems(system_of(box, placement.positions, 0.5)), "");
  const std::vector<double> fewer(placed, 0.5);
  EXPECT_EQ(place_at_random(box, fewer, 6, {}).positions.size(), placed) << "what it says can be placed can be placed";
  EXPECT_TRUE(place_at_random({.size = {0.9, 9}, .boundary = kReflecting}, radii, 6, {}).positions.empty());
}

TEST(RandomStart, DependsOnTheSeedAlone) {
  const std::vector<double> radii(50, 0.5);
  const Box box{.size = {15, 15}, .boundary = kPeriodic};
  EXPECT_EQ(place_at_random(box, radii, 7, {}).positions, place_at_random(box, radii, 7, {}).positions);
  EXPECT_NE(place_at_random(box, radii, 7, {}).positions, place_at_random(box, radii, 8, {}).positions);
}

// --- velocities ---------------------------------------------------------------------------------------------------

TEST(Velocities, OfEachTemperatureHaveTheirShareAndNoMomentum) {
  TestSystem test({.size = {100, 100}, .boundary = kReflecting});
  std::vector<double> temperatures;
  for (int k = 0; k < 300; ++k) {
    test.add({{}, 0.5, {}, k % 2 == 0 ? 1.0 : 7.0});
    temperatures.push_back(k < 100 ? 1.0 : 4.0);
  }
  draw_velocities(test.system, 0, temperatures, 1, test.frame);
  const auto check = [&](std::size_t first, std::size_t last, double kT) {
    double twice_energy = 0, scale = 0;
    Vec2 total;
    for (std::size_t k = first; k < last; ++k) {
      const Vec2 p = test.system.mass(k) * test.frame.velocity(k);
      twice_energy += dot(p, test.frame.velocity(k));
      total = total + p;
      scale += length(p);
    }
    EXPECT_NEAR(twice_energy / (2.0 * static_cast<double>(last - first)), kT, 1e-12 * kT);
    EXPECT_LT(length(total), 1e-14 * scale);
  };
  check(0, 100, 1);
  check(100, 300, 4);
}

TEST(Velocities, AreMaxwells) {
  TestSystem test({.size = {1, 1}, .boundary = kReflecting});
  constexpr std::size_t kDisks = 100'000;
  for (std::size_t k = 0; k < kDisks; ++k) test.add({{}, 0.5, {}, 4});
  draw_velocities(test.system, 0, std::vector<double>(kDisks, 9.0), 2, test.frame);
  double m2 = 0, m4 = 0, xy = 0;
  for (std::size_t k = 0; k < kDisks; ++k) {
    const double x = test.frame.vx[k] / 1.5;  // √(kT/m)
    m2 += x * x;
    m4 += x * x * x * x;
    xy += x * test.frame.vy[k] / 1.5;
  }
  EXPECT_NEAR(m2 / kDisks, 1, 5 * std::sqrt(2.0 / kDisks));
  EXPECT_NEAR(m4 / kDisks, 3, 5 * std::sqrt(96.0 / kDisks));
  EXPECT_NEAR(xy / kDisks, 0, 5 * std::sqrt(1.0 / kDisks));
}

TEST(Velocities, AtTemperatureZeroAreZero) {
  TestSystem test({.size = {10, 10}, .boundary = kPeriodic}, {{{1, 1}}, {{5, 5}}, {{7, 7}}});
  draw_velocities(test.system, 0, std::vector<double>(3, 0.0), 1, test.frame);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(test.frame.velocity(k), Vec2{});
}

TEST(Velocities, OfOtherDisksStay) {
  TestSystem test({.size = {10, 10}, .boundary = kPeriodic}, {{{1, 1}, 0.5, {3, 4}}, {{5, 5}}, {{7, 7}}});
  draw_velocities(test.system, 1, std::vector<double>(2, 1.0), 1, test.frame);
  EXPECT_EQ(test.frame.velocity(0), (Vec2{3, 4}));
  EXPECT_NE(test.frame.velocity(1), Vec2{});
}

}  // namespace
}  // namespace carom
