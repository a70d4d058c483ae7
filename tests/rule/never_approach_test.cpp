// Property: a pair that has collided does not approach, in the very arithmetic that asks; correcting it costs a few
// units in the last place.
#include <gtest/gtest.h>

#include <algorithm>

#include "random_contact.hpp"

namespace carom::rule {
namespace {

/// The outcome without the correction that this test is about.
Velocities uncorrected(const Contact& contact) {
  const double b = approach(contact.r, contact.v);
  return detail::with_impulse(contact, detail::change_of_relative_velocity(contact.r, b, contact.restitution));
}

/// Number of contacts whose plain outcome approaches again. Asserts that none does after collide().
int count_corrected(double restitution, int contacts) {
  RandomStream random(7, static_cast<std::uint64_t>(restitution * 1000), 0);
  int corrected = 0;
  for (int k = 0; k < contacts; ++k) {
    Contact contact = any_approaching(random);
    contact.restitution = restitution;
    const bool needs_it = approach(contact.r, uncorrected(contact)) < 0;
    corrected += needs_it;
    const Velocities after = collide(contact);
    EXPECT_GE(approach(contact.r, after), 0);
    if (!needs_it) {
      EXPECT_EQ(after, uncorrected(contact));
    }
    if (testing::Test::HasFailure()) break;
  }
  return corrected;
}

TEST(NeverApproach, WithoutRestitution) { EXPECT_GT(count_corrected(0, 200'000), 20'000); }

TEST(NeverApproach, WithAnyRestitution) {
  for (const double e : {1e-300, 1e-17, 1e-16, 1e-8, 0.1, 0.5, 0.999, 1.0}) count_corrected(e, 20'000);
}

TEST(NeverApproach, WhenItNearlySlides) {
  // Velocities almost along the tangent: the approach is lost in the rounding of the speeds.
  RandomStream random(8, 0, 0);
  for (int k = 0; k < 100'000; ++k) {
    Contact contact = any_contact(random);
    const Vec2 tangent{-contact.r.y, contact.r.x};
    contact.v.second = contact.v.first + any_size(random, 20) * tangent;
    contact.restitution = k % 2;
    ASSERT_GE(approach(contact.r, collide(contact)), 0);
  }
}

TEST(NeverApproach, NextToAWall) {
  RandomStream random(9, 0, 0);
  for (int k = 0; k < 20'000; ++k) {
    Contact contact = any_approaching(random);
    contact.m2 = INFINITY;
    contact.restitution = 0;
    const Velocities after = collide(contact);
    ASSERT_GE(approach(contact.r, after), 0);
    ASSERT_EQ(after.second, contact.v.second);
  }
}

TEST(NeverApproach, CorrectionIsOfTheOrderOfRounding) {
  RandomStream random(10, 0, 0);
  double largest = 0;
  for (int k = 0; k < 100'000; ++k) {
    Contact contact = any_approaching(random);
    contact.restitution = 0;
    const double left = approach(contact.r, collide(contact)) / length(contact.r);
    largest = std::max(largest, left / speeds(contact.v));
  }
  EXPECT_LT(largest, 16 * 0x1p-53);
}

TEST(NeverApproach, KeepsMomentumAndDoesNotAddEnergy) {
  RandomStream random(11, 0, 0);
  for (int k = 0; k < 100'000; ++k) {
    Contact c = any_approaching(random);
    c.restitution = 0;
    const Velocities after = collide(c);
    const Vec2 change = c.m1 * (after.first - c.v.first) + c.m2 * (after.second - c.v.second);
    ASSERT_LE(length(change), 1e-14 * (c.m1 * length(c.v.first) + c.m2 * length(c.v.second)));
    const double before = kinetic_energy(c.m1, c.v.first) + kinetic_energy(c.m2, c.v.second);
    ASSERT_LE(kinetic_energy(c.m1, after.first) + kinetic_energy(c.m2, after.second), before * (1 + 1e-14));
  }
}

}  // namespace
}  // namespace carom::rule
