// Property: vectors of the plane obey the rules of the plane, at compile time where no root is needed.
#include "carom/base/vec2.hpp"

#include <gtest/gtest.h>

namespace carom {
namespace {

constexpr Vec2 kA{3, -4};
constexpr Vec2 kB{0.5, 2};

static_assert(Vec2{} == Vec2{0, 0});
static_assert(kA + kB == Vec2{3.5, -2});
static_assert(kA - kB == Vec2{2.5, -6});
static_assert(-kA == Vec2{-3, 4});
static_assert(2 * kA == Vec2{6, -8} && kA * 2 == 2 * kA);
static_assert(kA / 2 == Vec2{1.5, -2});
static_assert(dot(kA, kB) == -6.5 && dot(kA, kB) == dot(kB, kA));
static_assert(cross(kA, kB) == 8 && cross(kA, kB) == -cross(kB, kA));
static_assert(cross({1, 0}, {0, 1}) == 1, "a quarter turn to the left is positive");
static_assert(cross(kA, kA) == 0);
static_assert(sizeof(Vec2) == 2 * sizeof(double), "no padding: vectors may be read as pairs of doubles");

TEST(Vec2, LengthIsTheRootOfTheSquare) {
  EXPECT_EQ(length(kA), 5);
  EXPECT_EQ(length(Vec2{}), 0);
  EXPECT_EQ(length({3e100, 4e100}), 5e100);
}

TEST(Vec2, DotAndCrossSplitTheProductOfTheLengths) {
  EXPECT_EQ(dot(kA, kB) * dot(kA, kB) + cross(kA, kB) * cross(kA, kB), dot(kA, kA) * dot(kB, kB));
}

}  // namespace
}  // namespace carom
