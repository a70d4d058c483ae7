// Property: rounding errors of the energy have no preferred sign, so that they do not add up over many collisions.
// With r·r rounded before the division, disks of diameter 1 would gain 5e-17 on average here.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "carom/base/random.hpp"
#include "carom/rule/collision.hpp"

namespace carom::rule {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_quad;

Exact twice_energy(const Velocities& v) {
  Exact sum = 0;
  for (const double component : {v.first.x, v.first.y, v.second.x, v.second.y}) sum += Exact(component) * component;
  return sum;
}

/// Centres at contact as a simulation has them: anywhere in a box, 1 apart to rounding.
Vec2 contact_vector(RandomStream& random) {
  const Vec2 centre{5 * random.uniform(), 5 * random.uniform()};
  const Vec2 direction{random.normal(), random.normal()};
  return (centre + direction / length(direction)) - centre;
}

TEST(Energy, RoundsWithoutBias) {
  RandomStream random(1, 2, 3);
  constexpr int kContacts = 200'000;
  double change = 0;
  double squares = 0;
  for (int k = 0; k < kContacts; ++k) {
    const Contact contact{.r = contact_vector(random),
                          .v = {{random.normal(), random.normal()}, {random.normal(), random.normal()}}};
    const auto error = static_cast<double>(twice_energy(collide(contact)) - twice_energy(contact.v));
    change += error;
    squares += error * error;
  }
  const double standard_error = std::sqrt(squares) / kContacts;
  EXPECT_LT(std::abs(change / kContacts), 4 * standard_error);
  EXPECT_LT(4 * standard_error, 5e-18) << "too few contacts to see the bias of the plain formula";
}

}  // namespace
}  // namespace carom::rule
