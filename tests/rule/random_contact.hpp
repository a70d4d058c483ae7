// Random contacts for the tests of the rule: masses and speeds over many decades, all directions.
#pragma once

#include <cmath>

#include "carom/base/random.hpp"
#include "carom/rule/collision.hpp"

namespace carom::rule {

/// Numbers of either sign whose sizes spread evenly over 2^-`octaves` … 2^`octaves`.
inline double any_size(RandomStream& random, int octaves) {
  const double size = std::exp2(octaves * (2 * random.uniform() - 1));
  return random.uniform() < 0.5 ? -size : size;
}

/// Masses 2^-20 … 2^20, speeds likewise (12 decades), r of length about 1, restitution 1.
inline Contact any_contact(RandomStream& random) {
  const auto vector = [&](int octaves) {
    const double angle = 6.283185307179586 * random.uniform();
    const double size = any_size(random, octaves);
    return Vec2{size * std::cos(angle), size * std::sin(angle)};
  };
  Contact contact{.r = vector(1), .v = {vector(20), vector(20)}};
  contact.m1 = std::abs(any_size(random, 20));
  contact.m2 = std::abs(any_size(random, 20));
  return contact;
}

/// The same, approaching.
inline Contact any_approaching(RandomStream& random) {
  Contact contact = any_contact(random);
  if (approach(contact.r, contact.v) > 0) contact.r = -contact.r;
  return contact;
}

/// |v1| + |v2|: what rounding errors of velocities are measured in.
inline double speeds(const Velocities& v) { return length(v.first) + length(v.second); }

}  // namespace carom::rule
