// Property: making and checking large systems takes time in proportion to their size. The limits are wide enough for a
// slow machine and an unoptimised build; anything quadratic in the number of disks misses them by orders of magnitude.
#include <gtest/gtest.h>

#include <ctime>

#include "carom/state/scene.hpp"
#include "carom/state/validate.hpp"
#include "make_system.hpp"

namespace carom {
namespace {

/// Processor time, which does not depend on what else the machine is doing.
double seconds(auto&& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Scene gas_of(std::uint64_t count, double packing) {
  Scene scene;
  scene.gas.push_back({.count = count, .packing_fraction = packing});
  return scene;
}

TEST(Large, ValidateAHundredThousand) {
  const auto setup = realize(gas_of(100'000, 0.7));
  EXPECT_LT(seconds([&] { EXPECT_TRUE(validate(setup.system, setup.frame).empty()); }), 2);
}

TEST(Large, LatticeOfAMillion) {
  EXPECT_LT(seconds([] { EXPECT_EQ(realize(gas_of(1'000'000, 0.7)).system.size(), 1'000'000u); }), 20);
}

TEST(Large, RandomStartOfAHundredThousand) {
  Scene scene = gas_of(100'000, 0.35);
  scene.gas[0].start = GasStart::random;
  EXPECT_LT(seconds([&] { EXPECT_EQ(realize(scene).system.size(), 100'000u); }), 15);
}

TEST(Large, GasAroundOneBigDisk) {
  Scene scene;
  scene.size = Vec2{400, 400};
  scene.disks.push_back({.position = {200, 200}, .radius = 60});
  scene.gas.push_back({.count = 100'000});
  EXPECT_LT(seconds([&] { EXPECT_EQ(realize(scene).system.size(), 100'001u); }), 10);
}

TEST(Large, GasAmongManyDisks) {
  Scene scene;
  scene.size = Vec2{1000, 1000};
  for (int k = 0; k < 10'000; ++k) {
    scene.disks.push_back({.position = {10.0 * (k % 100) + 5, 10.0 * (k / 100) + 5}, .radius = 2});
  }
  scene.gas.push_back({.count = 50'000});
  EXPECT_LT(seconds([&] { EXPECT_EQ(realize(scene).system.size(), 60'000u); }), 10);
}

TEST(Large, HundredThousandTinyDisksBesideAHugeOne) {
  TestSystem test({.size = {1000, 1000}, .boundary = kPeriodic}, {{{500, 500}, 300}});
  for (int k = 0; k < 100'000; ++k) test.add({{2.0 * (k % 500) + 1, 0.9 * (k / 500) + 0.5}, 0.4});
  EXPECT_LT(seconds([&] { EXPECT_TRUE(validate(test.system, test.frame).empty()); }), 4);
}

}  // namespace
}  // namespace carom
