// Property: a system knows its disks' kinds, its packing fraction and its degrees of freedom.
#include "carom/state/system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "make_system.hpp"

namespace carom {
namespace {

TEST(System, EqualKindsShareOneEntry) {
  System system;
  for (int k = 0; k < 3; ++k) {
    system.add_disk({0.5, 1});
    system.add_disk({0.5, 2});
  }
  EXPECT_EQ(system.size(), 6u);
  EXPECT_EQ(system.species.size(), 2u);
  EXPECT_EQ(system.mass(4), 1);
  EXPECT_EQ(system.mass(5), 2);
  EXPECT_EQ(system.species_of_disk(5), (Species{0.5, 2}));
}

// A NaN once compared equal to every kind in an ordered map, and so vanished into the first.
TEST(System, NumbersThatAreNotNumbersStayWhatTheyAre) {
  System system;
  system.add_disk({0.5, 1});
  system.add_disk({std::numeric_limits<double>::quiet_NaN(), 1});
  system.add_disk({0.5, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(system.radius(0), 0.5);
  EXPECT_TRUE(std::isnan(system.radius(1)));
  EXPECT_TRUE(std::isnan(system.mass(2)));
}

TEST(System, LargestRadius) {
  System system;
  EXPECT_EQ(system.largest_radius(), 0);
  for (const double radius : {0.5, 3.0, 0.25}) system.add_disk({radius, 1});
  EXPECT_EQ(system.largest_radius(), 3);
}

TEST(System, PackingFractionIsAreaOverArea) {
  TestSystem test({.size = {4, 2}, .boundary = kPeriodic}, {{{1, 1}, 1}, {{3, 1}, 0.5}});
  EXPECT_DOUBLE_EQ(packing_fraction(test.system), kPi * 1.25 / 8);
  test.system.box.size = {0, 0};
  EXPECT_EQ(packing_fraction(test.system), 0) << "an open plane";
}

TEST(System, DegreesOfFreedomLoseOnePerConservedAxis) {
  TestSystem test({.size = {4, 4}, .boundary = kPeriodic}, {{{1, 1}}, {{3, 1}}, {{3, 3}}});
  EXPECT_EQ(degrees_of_freedom(test.system), 4);
  test.system.box.boundary = kMixed;
  EXPECT_EQ(degrees_of_freedom(test.system), 5);
  test.system.box.boundary = kReflecting;
  EXPECT_EQ(degrees_of_freedom(test.system), 6);
  test.system.box.boundary = kOpen;
  EXPECT_EQ(degrees_of_freedom(test.system), 4);
}

TEST(Box, MomentumIsConservedWhereThereIsNoWall) {
  const Box box{.size = {1, 1}, .boundary = kMixed};
  EXPECT_TRUE(box.periodic(0) && !box.periodic(1) && box.reflecting(1));
  EXPECT_TRUE(box.conserves_momentum(0) && !box.conserves_momentum(1));
  EXPECT_TRUE(box.has_walls());
  EXPECT_FALSE((Box{.size = {1, 1}, .boundary = kPeriodic}.has_walls()));
}

TEST(Boundary, HasAName) {
  EXPECT_EQ(name_of(Boundary::periodic), "periodic");
  EXPECT_EQ(name_of(Boundary::reflecting), "reflecting");
  EXPECT_EQ(name_of(Boundary::open), "open");
}

}  // namespace
}  // namespace carom
