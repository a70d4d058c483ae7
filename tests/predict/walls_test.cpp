// Property: at the predicted time the disk's rim is at the wall, up to rounding; a disk that does not approach a wall
// never meets it, one that is past it and approaches meets it at once.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "carom/base/random.hpp"
#include "carom/predict/contact.hpp"

namespace carom::predict {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;

static_assert(contact_with_wall(6, 2, 10) == 13);
static_assert(contact_with_wall(6, 0, 10) == kNever && contact_with_wall(6, -2, 10) == kNever);
static_assert(contact_with_wall(0, 2, 10) == 10 && contact_with_wall(-1, 2, 10) == 10, "touching or past it");
static_assert(contact_with_wall(0, 0, 10) == kNever && contact_with_wall(-1, -2, 10) == kNever);
static_assert(contact_with_wall(-1, -0.0, 10) == kNever, "what an inelastic wall leaves is not approaching");

static_assert(contact_with_low_wall(3, -1, 0, 0.5) == 2.5 && contact_with_low_wall(3, 1, 0, 0.5) == kNever);
static_assert(contact_with_high_wall(3, 1, 0, 0.5, 10) == 6.5 && contact_with_high_wall(3, -1, 0, 0.5, 10) == kNever);

struct Case {
  double x, v, time, radius, size;
};

Case any_case(RandomStream& random) {
  const double size = std::exp2(40 * random.uniform() - 20);
  const double radius = 0.5 * size * random.uniform();
  const double x = radius + (size - 2 * radius) * random.uniform();
  const double v = std::exp2(80 * random.uniform() - 40) * (random.uniform() < 0.5 ? -1 : 1);
  return {x, v, std::exp2(20 * random.uniform() - 10), radius, size};
}

// Backward error: four roundings (rim, distance, quotient, sum), each of a half unit of the lengths involved.
TEST(Walls, RimIsAtTheWall) {
  RandomStream random(1, 0, 0);
  for (int k = 0; k < 20'000; ++k) {
    const Case c = any_case(random);
    const double low = contact_with_low_wall(c.x, c.v, c.time, c.radius);
    const double high = contact_with_high_wall(c.x, c.v, c.time, c.radius, c.size);
    ASSERT_EQ(low == kNever, c.v > 0);
    ASSERT_EQ(high == kNever, c.v < 0);
    const double time = std::min(low, high);
    ASSERT_GE(time, c.time);
    const Exact at = c.x + Exact(c.v) * (Exact(time) - c.time);
    const auto gap = static_cast<double>(c.v < 0 ? at - c.radius : c.size - c.radius - at);
    ASSERT_LE(std::abs(gap), 4 * 0x1p-53 * (c.size + std::abs(c.v) * time));
  }
}

TEST(Walls, PastTheWall) {
  RandomStream random(2, 0, 0);
  for (int k = 0; k < 1000; ++k) {
    const Case c = any_case(random);
    const double beyond = c.radius * (1 - 1e-10 * random.uniform());
    EXPECT_EQ(contact_with_low_wall(beyond, -std::abs(c.v), c.time, c.radius), c.time);
    EXPECT_EQ(contact_with_low_wall(beyond, std::abs(c.v), c.time, c.radius), kNever);
    EXPECT_EQ(contact_with_high_wall(c.size - beyond + 0x1p-40 * c.size, std::abs(c.v), c.time, c.radius, c.size),
              c.time);
    EXPECT_EQ(contact_with_high_wall(c.size - beyond, -std::abs(c.v), c.time, c.radius, c.size), kNever);
  }
}

}  // namespace
}  // namespace carom::predict
