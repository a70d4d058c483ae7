// Property: every equation of the source text gives the numbers that one gets by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "carom/rule/collision.hpp"
#include "carom/rule/decomposition.hpp"
#include "carom/rule/one_dimension.hpp"

namespace carom::rule {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// --- one dimension --------------------------------------------------------------------------------------------

// m1 = 2 with v1 = 5 meets m2 = 3 with v2 = −5: by hand v1' = −7, v2' = 3.
constexpr LineVelocities kHeadOn = collide_on_line(2, 5, 3, -5);

static_assert(kHeadOn.v2 == (2.0 * 2 * 5 + -5 * (3 - 2)) / (2 + 3) && kHeadOn.v2 == 3, "equation 5");
static_assert(kHeadOn.v1 == (5.0 * (2 - 3) + 2 * 3 * -5) / (2 + 3) && kHeadOn.v1 == -7, "equation 6");
static_assert(2 * 5 + 3 * -5 == 2 * kHeadOn.v1 + 3 * kHeadOn.v2, "equation 1: momentum −5");
static_assert(0.5 * 2 * 25 + 0.5 * 3 * 25 == 0.5 * 2 * 49 + 0.5 * 3 * 9, "equation 2: energy 62.5");
static_assert(kinetic_energy(2, {5, 0}) + kinetic_energy(3, {-5, 0}) == 62.5, "equation 2's summands");
static_assert(2 * (5 - kHeadOn.v1) == 3 * (kHeadOn.v2 - -5), "equation 3: 24 on both sides");
static_assert(2 * (25 - kHeadOn.v1 * kHeadOn.v1) == 3 * (kHeadOn.v2 * kHeadOn.v2 - 25), "equation 4: −48");
static_assert(5 + kHeadOn.v1 == kHeadOn.v2 + -5, "equation 4 divided by equation 3");

static_assert(collide_on_line(4, 1, 4, -3) == LineVelocities{-3, 1}, "equal masses exchange their velocities");
static_assert(collide_on_line_equal_masses(1, -3) == LineVelocities{-3, 1});
static_assert(collide_on_line(3, 2, 1, -2) == LineVelocities{0, 4}, "swapping the bodies turns 5 into 6 …");
static_assert(collide_on_line(1, -2, 3, 2) == LineVelocities{4, 0}, "… and 6 into 5");
static_assert(collide_on_line(1, 7, 2, 7) == LineVelocities{7, 7}, "what does not approach does not change");

// With restitution: (1+e) = 1.5, relative velocity −10, shares 3/5 and 2/5: −4 and 1.
TEST(Restitution, OnALineByHand) {
  const LineVelocities after = collide_on_line(2, 5, 3, -5, 0.5);
  EXPECT_DOUBLE_EQ(after.v1, -4);
  EXPECT_DOUBLE_EQ(after.v2, 1);
  EXPECT_DOUBLE_EQ(after.v2 - after.v1, -0.5 * (-5 - 5));
}
static_assert(collide_on_line(1, 6, 1, 2, 0) == LineVelocities{4, 4}, "e = 0: both go on together");
static_assert(collide_on_line(1, 3, kInfinity, 0, 1) == LineVelocities{-3, 0}, "a wall");
static_assert(collide_on_line(1, 3, kInfinity, 1, 0.5) == LineVelocities{0, 1}, "a moving wall");

static_assert(share_of_first(1, 3) == 0.75 && share_of_first(3, 1) == 0.25);
static_assert(share_of_first(1, kInfinity) == 1 && share_of_first(kInfinity, 1) == 0);

// --- normal and tangent ---------------------------------------------------------------------------------------

TEST(UnitNormal, PointsFromCentre1ToCentre2) {
  EXPECT_EQ(unit_normal({1, 2}, {4, -2}), (Vec2{0.6, -0.8}));
  EXPECT_EQ(unit_normal({1, 2}, {1, 9}), (Vec2{0, 1}));
  EXPECT_EQ(unit_normal({4, -2}, {1, 2}), (Vec2{-0.6, 0.8}));
}

TEST(UnitNormal, StaysInTheRangeOfDoubles) {
  for (const double scale : {1e-300, 1e-160, 1e160, 1e300}) {
    const Vec2 n = unit_normal({0, 0}, {3 * scale, 4 * scale});
    EXPECT_NEAR(n.x, 0.6, 1e-15) << scale;
    EXPECT_NEAR(n.y, 0.8, 1e-15) << scale;
  }
}

static_assert(unit_tangent({0.6, 0.8}) == Vec2{-0.8, 0.6}, "not ⟨−0.8, −0.6⟩, as one line of the text has it");
static_assert(dot(Vec2{0.6, 0.8}, unit_tangent({0.6, 0.8})) == 0);
static_assert(cross(Vec2{1, 0}, unit_tangent({1, 0})) == 1, "turned to the left");

// un = ⟨0, 1⟩, ut = ⟨−1, 0⟩: v_n is v_y and v_t is −v_x.
static_assert(decompose({3, 5}, {0, 1}) == Parts{5, -3});
static_assert(compose({5, -3}, {0, 1}) == Vec2{3, 5});

TEST(Projection, ByHand) {
  const Parts parts = decompose({1, 2}, {0.6, 0.8});
  EXPECT_DOUBLE_EQ(parts.normal, 2.2);      // 0.6 + 1.6
  EXPECT_DOUBLE_EQ(parts.tangential, 0.4);  // −0.8 + 1.2
  const Vec2 again = compose(parts, {0.6, 0.8});
  EXPECT_DOUBLE_EQ(again.x, 1);  // 0.6·2.2 − 0.8·0.4
  EXPECT_DOUBLE_EQ(again.y, 2);  // 0.8·2.2 + 0.6·0.4
}

// General masses: the normal parts follow 5 and 6 (with m2 − m1, where the text prints m1 − m2), the tangential
// parts stay. m1 = 2, m2 = 1, v1n = 1, v2n = −1: −1/3 and 5/3.
TEST(GeneralMasses, NormalPartsByHand) {
  const CollidedParts after = collide_parts(2, {1, 10}, 1, {-1, 20});
  EXPECT_DOUBLE_EQ(after.first.normal, -1.0 / 3);
  EXPECT_DOUBLE_EQ(after.second.normal, 5.0 / 3);
  EXPECT_EQ(after.first.tangential, 10);
  EXPECT_EQ(after.second.tangential, 20);
}

// m1 = 3, m2 = 1, r = ⟨0.6, 0.8⟩, v1 = ⟨1, 0⟩, v2 = 0: v1' = ⟨0.82, −0.24⟩, v2' = ⟨0.54, 0.72⟩.
TEST(GeneralMasses, VelocitiesByHand) {
  const Velocities after = collide({.r = {0.6, 0.8}, .v = {{1, 0}, {0, 0}}, .m1 = 3, .m2 = 1});
  EXPECT_DOUBLE_EQ(after.first.x, 0.82);
  EXPECT_DOUBLE_EQ(after.first.y, -0.24);
  EXPECT_DOUBLE_EQ(after.second.x, 0.54);
  EXPECT_DOUBLE_EQ(after.second.y, 0.72);
  const Vec2 n{0.6, 0.8};
  const CollidedParts parts = collide_parts(3, decompose({1, 0}, n), 1, decompose({0, 0}, n));
  EXPECT_NEAR(compose(parts.first, n).x, after.first.x, 1e-15);
  EXPECT_NEAR(compose(parts.first, n).y, after.first.y, 1e-15);
  EXPECT_NEAR(compose(parts.second, n).x, after.second.x, 1e-15);
  EXPECT_NEAR(compose(parts.second, n).y, after.second.y, 1e-15);
}

// --- equal masses: A, B, C, D ---------------------------------------------------------------------------------

// Δx = 1, Δy = 2, v1 = ⟨3, 4⟩, v2 = ⟨−5, 6⟩; denominator 5.
constexpr Velocities kAfter = collide_equal_masses({1, 2}, {{3, 4}, {-5, 6}});

static_assert(kAfter.first.x == (-5.0 * 1 + 6 * 2 + 3 * 4 - 4 * 2) / 5 && kAfter.first.x == 2.2, "equation A");
static_assert(kAfter.first.y == (-5.0 * 2 + 6 * 4 - 3 * 2 + 4 * 1) / 5 && kAfter.first.y == 2.4, "equation B");
static_assert(kAfter.second.x == (3.0 * 1 + 4 * 2 + -5 * 4 - 6 * 2) / 5 && kAfter.second.x == -4.2, "equation C");
static_assert(kAfter.second.y == (3.0 * 2 + 4 * 4 - -5 * 2 + 6 * 1) / 5 && kAfter.second.y == 7.6, "equation D");

// The worked example of the documentation: v1 = ⟨1, 0⟩ meets a disk at rest along ⟨0.6, 0.8⟩.
TEST(EqualMasses, WorkedExample) {
  for (const Velocities& after :
       {collide_equal_masses({0.6, 0.8}, {{1, 0}, {0, 0}}), collide({.r = {0.6, 0.8}, .v = {{1, 0}, {0, 0}}}),
        collide({.r = {3, 4}, .v = {{1, 0}, {0, 0}}, .m1 = 7, .m2 = 7})}) {
    EXPECT_DOUBLE_EQ(after.first.x, 0.64);
    EXPECT_DOUBLE_EQ(after.first.y, -0.48);
    EXPECT_DOUBLE_EQ(after.second.x, 0.36);
    EXPECT_DOUBLE_EQ(after.second.y, 0.48);
    EXPECT_NEAR(dot(after.first, after.second), 0, 1e-16);
  }
}

// The same with e = 0.5: v1' = ⟨0.73, −0.36⟩, v2' = ⟨0.27, 0.36⟩, energy 0.4325.
TEST(Restitution, WorkedExample) {
  const Velocities after = collide({.r = {0.6, 0.8}, .v = {{1, 0}, {0, 0}}, .restitution = 0.5});
  EXPECT_DOUBLE_EQ(after.first.x, 0.73);
  EXPECT_DOUBLE_EQ(after.first.y, -0.36);
  EXPECT_DOUBLE_EQ(after.second.x, 0.27);
  EXPECT_DOUBLE_EQ(after.second.y, 0.36);
  EXPECT_DOUBLE_EQ(kinetic_energy(1, after.first) + kinetic_energy(1, after.second), 0.4325);
}

}  // namespace
}  // namespace carom::rule
