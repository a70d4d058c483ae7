// Property: velocities after a collision are those of exact arithmetic to a few units in the last place of the speeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "random_contact.hpp"

namespace carom::rule {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;
constexpr double kUnit = 0x1p-53;

struct ExactVelocities {
  Exact x1, y1, x2, y2;
};

/// (xi) and (xii) of the documentation, in 100 digits.
ExactVelocities collide_exactly(const Contact& c) {
  const Exact rx = c.r.x, ry = c.r.y;
  const Exact b = rx * (Exact(c.v.second.x) - c.v.first.x) + ry * (Exact(c.v.second.y) - c.v.first.y);
  const Exact change = (1 + Exact(c.restitution)) * b / (rx * rx + ry * ry);
  const Exact total = Exact(c.m1) + c.m2;
  return {c.v.first.x + change * (c.m2 / total) * rx, c.v.first.y + change * (c.m2 / total) * ry,
          c.v.second.x - change * (c.m1 / total) * rx, c.v.second.y - change * (c.m1 / total) * ry};
}

double largest_error(const Velocities& v, const ExactVelocities& exact) {
  const auto error = [](double value, const Exact& wanted) { return static_cast<double>(abs(value - wanted)); };
  return std::max({error(v.first.x, exact.x1), error(v.first.y, exact.y1), error(v.second.x, exact.x2),
                   error(v.second.y, exact.y2)});
}

// The path from v to v' has 11 roundings, none after a cancellation that is not measured in |v1| + |v2|; each is
// half a unit of a number of at most 2 (|v1| + |v2|).
TEST(Collide, AgreesWithExactArithmetic) {
  RandomStream random(1, 0, 0);
  double worst = 0;
  for (int k = 0; k < 20'000; ++k) {
    Contact contact = any_approaching(random);
    contact.restitution = k % 3 == 0 ? 1 : random.uniform();
    const double error = largest_error(collide(contact), collide_exactly(contact));
    worst = std::max(worst, error / (kUnit * speeds(contact.v)));
  }
  EXPECT_LT(worst, 16);
  EXPECT_GT(worst, 0.1) << "a test that sees no rounding at all compares a thing with itself";
}

TEST(CollideEqualMasses, AgreesWithExactArithmetic) {
  RandomStream random(2, 0, 0);
  for (int k = 0; k < 20'000; ++k) {
    Contact contact = any_approaching(random);
    contact.m1 = contact.m2 = 1;
    const double error = largest_error(collide_equal_masses(contact.r, contact.v), collide_exactly(contact));
    ASSERT_LT(error, 16 * kUnit * speeds(contact.v));
  }
}

// Momentum and energy, summed in 100 digits so that only the rule's own rounding is seen.
TEST(Collide, KeepsMomentumAndEnergyOverTwelveDecades) {
  RandomStream random(3, 0, 0);
  for (int k = 0; k < 20'000; ++k) {
    const Contact c = any_approaching(random);
    const Velocities after = collide(c);
    const auto sum = [&](auto of) {
      return std::pair{c.m1 * of(c.v.first) + c.m2 * of(c.v.second), c.m1 * of(after.first) + c.m2 * of(after.second)};
    };
    const auto px = sum([](Vec2 v) { return Exact(v.x); });
    const auto py = sum([](Vec2 v) { return Exact(v.y); });
    const auto energy = sum([](Vec2 v) { return (Exact(v.x) * v.x + Exact(v.y) * v.y) / 2; });
    const double scale = c.m1 * length(c.v.first) + c.m2 * length(c.v.second);
    ASSERT_LE(static_cast<double>(abs(px.second - px.first)), 1e-14 * scale);
    ASSERT_LE(static_cast<double>(abs(py.second - py.first)), 1e-14 * scale);
    ASSERT_LE(static_cast<double>(abs(energy.second / energy.first - 1)), 1e-14);
  }
}

}  // namespace
}  // namespace carom::rule
