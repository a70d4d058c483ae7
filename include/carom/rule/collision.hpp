// The collision rule of two disks as carom computes it: one impulse along the line of centres.
#pragma once

#include <cmath>

#include "carom/base/vec2.hpp"
#include "carom/rule/one_dimension.hpp"

namespace carom::rule {

/// Two velocities (length/time), of body 1 and body 2.
struct Velocities {
  Vec2 first;
  Vec2 second;

  friend constexpr bool operator==(const Velocities&, const Velocities&) = default;
};

/// v·r with v = v2 − v1 and r from centre 1 to centre 2: negative while the two approach.
constexpr double approach(Vec2 r, Velocities v) noexcept { return dot(r, v.second - v.first); }

/// Equal masses in closed form, without a square root (source text, equations A, B, C and D).
/// `r` runs from centre 1 to centre 2, of any length but zero. Elastic; does not ask whether they approach.
constexpr Velocities collide_equal_masses(Vec2 r, Velocities v) noexcept {
  const double r2 = r.x * r.x + r.y * r.y;
  const Vec2 v1 = v.first;
  const Vec2 v2 = v.second;
  return {{(v2.x * r.x * r.x + v2.y * r.x * r.y + v1.x * r.y * r.y - v1.y * r.x * r.y) / r2,    // A
           (v2.x * r.x * r.y + v2.y * r.y * r.y - v1.x * r.y * r.x + v1.y * r.x * r.x) / r2},   // B
          {(v1.x * r.x * r.x + v1.y * r.x * r.y + v2.x * r.y * r.y - v2.y * r.x * r.y) / r2,    // C
           (v1.x * r.x * r.y + v1.y * r.y * r.y - v2.x * r.y * r.x + v2.y * r.x * r.x) / r2}};  // D
}

/// What two disks bring into a collision.
struct Contact {
  Vec2 r;                  ///< from centre 1 to centre 2; its length between 1e-150 and 1e150
  Velocities v;            ///< before the collision (length/time)
  double m1 = 1;           ///< mass, positive; infinite for a wall
  double m2 = 1;           ///< mass, positive; infinite for a wall; not both infinite
  double restitution = 1;  ///< e in [0, 1]
};

namespace detail {

/// A number as the nearest double and what that leaves out.
struct Unrounded {
  double value = 0;
  double rest = 0;
};

/// a b without rounding (T. J. Dekker, Numer. Math. 18, 224 (1971)); exact while a, b, and a b are between 1e-130
/// and 1e150, and nearly so below.
constexpr Unrounded product(double a, double b) noexcept {
  constexpr double kSplit = 0x1p27 + 1;
  const double a_high = kSplit * a - (kSplit * a - a);  // the upper 26 bits
  const double b_high = kSplit * b - (kSplit * b - b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  const double value = a * b;
  return {value, a_low * b_low - (((value - a_high * b_high) - a_low * b_high) - a_high * b_low)};
}

/// r·r to some 30 digits.
constexpr Unrounded squared_length(Vec2 r) noexcept {
  const Unrounded x = product(r.x, r.x);
  const Unrounded y = product(r.y, r.y);
  const double value = x.value + y.value;
  const double y_part = value - x.value;
  const double rest = (x.value - (value - y_part)) + (y.value - y_part);
  return {value, rest + (x.rest + y.rest)};
}

/// (1+e) (v·r)/(r·r), rounded once: by how many r the relative velocity changes.
///
/// At contact r·r lies within rounding of σ², and where σ² is a power of two, as for disks of diameter 1, doubles are
/// twice as dense below it as above. A rounded r·r is then too small on average, and every collision would add some
/// 10⁻¹⁷ of the pair's energy, always with the same sign.
constexpr double change_of_relative_velocity(Vec2 r, double b, double restitution) noexcept {
  const double dividend = (1 + restitution) * b;
  const Unrounded divisor = squared_length(r);
  const double quotient = dividend / divisor.value;
  const Unrounded back = product(quotient, divisor.value);
  const double remainder = ((dividend - back.value) - back.rest) - quotient * divisor.rest;
  return quotient + remainder / divisor.value;
}

/// Velocities after an impulse along r that changes the relative velocity by `change` times r.
constexpr Velocities with_impulse(const Contact& contact, double change) noexcept {
  return {contact.v.first + (change * share_of_first(contact.m1, contact.m2)) * contact.r,
          contact.v.second - (change * share_of_first(contact.m2, contact.m1)) * contact.r};
}

/// Where rounding left the pair approaching after its collision: enlarges the impulse by
/// 2⁻⁵³ μ Σ|v components|, doubled until the pair does not approach.
[[gnu::cold, gnu::noinline]] inline Velocities separate(const Contact& contact, double change) noexcept {
  const Velocities& v = contact.v;
  const double speeds = (std::abs(v.first.x) + std::abs(v.first.y)) + (std::abs(v.second.x) + std::abs(v.second.y));
  double extra = 0x1p-53 * speeds / length(contact.r);
  Velocities after = with_impulse(contact, change - extra);
  // 64 doublings reach 2000 times the speeds: more than any collision changes; a handful is what it takes.
  for (int doubling = 0; doubling < 64 && approach(contact.r, after) < 0; ++doubling) {
    extra *= 2;
    after = with_impulse(contact, change - extra);
  }
  return after;
}

}  // namespace detail

/// Velocities after the collision: body 1 gains J/m1 and body 2 loses J/m2 with
/// J = (1+e) μ (v·r)/(r·r) r, μ = m1 m2/(m1+m2). Along `r` these are equations 5 and 6, across it nothing
/// changes; for equal masses and e = 1 it is A–D. Momentum is kept for every e, kinetic energy for e = 1.
/// A pair that does not approach keeps its velocities; a pair that has collided does not approach.
constexpr Velocities collide(const Contact& contact) noexcept {
  const double b = approach(contact.r, contact.v);
  if (!(b < 0)) return contact.v;
  const double change = detail::change_of_relative_velocity(contact.r, b, contact.restitution);
  const Velocities after = detail::with_impulse(contact, change);
  return approach(contact.r, after) < 0 ? detail::separate(contact, change) : after;
}

/// The impulse on body 2 (mass × length/time), from its change of velocity; on body 1 it is the opposite.
/// `m2` finite.
constexpr Vec2 impulse_on_second(double m2, Velocities before, Velocities after) noexcept {
  return m2 * (after.second - before.second);
}

/// Velocity of a disk after it met a fixed wall across its path: the component along the wall's normal
/// becomes −e times what it was (a contact with an infinite mass at rest), the other stays.
constexpr double reflect(double normal_velocity, double restitution) noexcept { return -restitution * normal_velocity; }

/// Kinetic energy ½ m v² (equation 2's summand).
constexpr double kinetic_energy(double mass, Vec2 velocity) noexcept { return 0.5 * mass * dot(velocity, velocity); }

}  // namespace carom::rule
