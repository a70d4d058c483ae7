// The elastic collision on a line: equations 1–6 of the source text.
#pragma once

namespace carom::rule {

/// Velocities of two bodies on a line (length/time, signed).
struct LineVelocities {
  double v1 = 0;
  double v2 = 0;

  friend constexpr bool operator==(const LineVelocities&, const LineVelocities&) = default;
};

/// The share m_b / (m_a + m_b) of a velocity change that falls to body a, written so that an infinite
/// m_b gives 1 and an infinite m_a gives 0. The caller guarantees positive masses, at most one infinite.
constexpr double share_of_first(double mass_a, double mass_b) noexcept { return 1 / (1 + mass_a / mass_b); }

/// Velocities after a head-on elastic collision (source text, equations 6 and 5). Masses positive and
/// finite; nothing is said about whether the bodies approach.
constexpr LineVelocities collide_on_line(double m1, double v1, double m2, double v2) noexcept {
  const double total = m1 + m2;
  return {(v1 * (m1 - m2) + 2 * m2 * v2) / total,   // equation 6
          (2 * m1 * v1 + v2 * (m2 - m1)) / total};  // equation 5
}

/// The same for equal masses: the velocities are exchanged (note below equation 6).
constexpr LineVelocities collide_on_line_equal_masses(double v1, double v2) noexcept { return {v2, v1}; }

/// The same with restitution e in [0, 1]: the relative velocity becomes −e times what it was. Momentum is
/// kept for every e, kinetic energy only for e = 1. One mass may be infinite (a wall).
constexpr LineVelocities collide_on_line(double m1, double v1, double m2, double v2, double restitution) noexcept {
  const double change = (1 + restitution) * (v2 - v1);
  return {v1 + share_of_first(m1, m2) * change, v2 - share_of_first(m2, m1) * change};
}

}  // namespace carom::rule
