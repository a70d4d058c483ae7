// Property: the rule acts on approaching pairs only, at compile time too, and a wall is a body of infinite mass.
#include "carom/rule/collision.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace carom::rule {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

static_assert(approach({1, 0}, {{1, 5}, {-1, 9}}) == -2, "negative while they approach");
static_assert(approach({1, 0}, {{-1, 5}, {1, 9}}) == 2);
static_assert(approach({0, 2}, {{7, 1}, {-7, 1}}) == 0, "sliding past each other is not approaching");

static_assert(collide({.r = {1, 0}, .v = {{1, 2}, {-1, 3}}}) == Velocities{{-1, 2}, {1, 3}}, "head-on: exchange");
static_assert(collide({.r = {1, 0}, .v = {{-1, 2}, {1, 3}}}) == Velocities{{-1, 2}, {1, 3}}, "receding: untouched");
static_assert(collide({.r = {1, 0}, .v = {{1, 2}, {1, -3}}}) == Velocities{{1, 2}, {1, -3}}, "sliding: untouched");
static_assert(collide({.r = {2, 0}, .v = {{4, 0}, {0, 0}}, .m1 = 3, .m2 = 1}) == Velocities{{2, 0}, {6, 0}});
static_assert(collide({.r = {2, 0}, .v = {{4, 0}, {0, 0}}, .restitution = 0}) == Velocities{{2, 0}, {2, 0}});
static_assert(collide({.r = {1, 0}, .v = {{3, 4}, {0, 0}}, .m2 = kInfinity}) == Velocities{{-3, 4}, {0, 0}});
static_assert(collide({.r = {1, 0}, .v = {{0, 0}, {-3, 4}}, .m1 = kInfinity}) == Velocities{{0, 0}, {3, 4}});
static_assert(collide({.r = {1, 0}, .v = {{3, 4}, {0, 0}}, .m2 = kInfinity, .restitution = 0.5}).first ==
              Vec2{reflect(3, 0.5), 4});

static_assert(impulse_on_second(2, {{1, 0}, {0, 0}}, {{0, 0}, {1, 3}}) == Vec2{2, 6});
static_assert(reflect(-3, 1) == 3 && reflect(3, 0.25) == -0.75 && reflect(3, 0) == 0);
static_assert(kinetic_energy(4, {3, -4}) == 50);

TEST(Collide, SpeedsThatAreNotNumbersAreNotTouched) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Velocities after = collide({.r = {1, 0}, .v = {{nan, 1}, {0, 2}}});
  EXPECT_TRUE(std::isnan(after.first.x));
  EXPECT_EQ(after.second, (Vec2{0, 2}));
}

TEST(Collide, HeavyPassesOnTwiceItsSpeed) {
  const Velocities after = collide({.r = {1, 0}, .v = {{1, 0}, {0, 0}}, .m1 = 1e15, .m2 = 1});
  EXPECT_NEAR(after.first.x, 1, 1e-14);
  EXPECT_NEAR(after.second.x, 2, 1e-14);
}

TEST(Collide, ThreeEqualDisksInARowPassTheVelocityOn) {
  const Vec2 r{0.6, 0.8};
  Vec2 a = 2.0 * r, b{}, c{};
  const Velocities first = collide({.r = r, .v = {a, b}});
  const Velocities second = collide({.r = r, .v = {first.second, c}});
  a = first.first, b = second.first, c = second.second;
  EXPECT_NEAR(length(a), 0, 1e-15);
  EXPECT_NEAR(length(b), 0, 1e-15);
  EXPECT_NEAR(length(c - 2.0 * r), 0, 1e-15);
}

TEST(Collide, WorksAtBothEndsOfTheRangeOfLengths) {
  const Velocities expected = collide({.r = {0.6, 0.8}, .v = {{1, 2}, {-1, 0.5}}, .m1 = 2, .m2 = 5});
  for (const double scale : {0x1p-490, 0x1p-100, 0x1p100, 0x1p490}) {
    EXPECT_EQ(collide({.r = scale * Vec2{0.6, 0.8}, .v = {{1, 2}, {-1, 0.5}}, .m1 = 2, .m2 = 5}), expected) << scale;
  }
}

}  // namespace
}  // namespace carom::rule
