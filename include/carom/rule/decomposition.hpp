// Normal and tangential parts of a velocity: the source text's way of taking a collision apart.
#pragma once

#include "carom/base/vec2.hpp"
#include "carom/rule/one_dimension.hpp"

namespace carom::rule {

/// Unit vector un from centre 1 to centre 2. The caller guarantees that the centres differ.
inline Vec2 unit_normal(Vec2 centre1, Vec2 centre2) noexcept {
  const Vec2 n = centre2 - centre1;
  const double largest = std::abs(n.x) > std::abs(n.y) ? std::abs(n.x) : std::abs(n.y);
  const Vec2 scaled = n / largest;  // neither tiny nor huge distances leave the range of doubles
  return scaled / length(scaled);
}

/// Unit tangent ut = ⟨−un_y, un_x⟩: the unit normal turned by a quarter turn to the left.
constexpr Vec2 unit_tangent(Vec2 unit_normal) noexcept { return {-unit_normal.y, unit_normal.x}; }

/// A velocity as its signed parts along the unit normal and the unit tangent (length/time).
struct Parts {
  double normal = 0;
  double tangential = 0;

  friend constexpr bool operator==(const Parts&, const Parts&) = default;
};

/// v_n = un·v and v_t = ut·v.
constexpr Parts decompose(Vec2 velocity, Vec2 unit_normal) noexcept {
  return {dot(unit_normal, velocity), dot(unit_tangent(unit_normal), velocity)};
}

/// v = v_n un + v_t ut.
constexpr Vec2 compose(Parts parts, Vec2 unit_normal) noexcept {
  return parts.normal * unit_normal + parts.tangential * unit_tangent(unit_normal);
}

/// The parts of two velocities, of body 1 and body 2.
struct CollidedParts {
  Parts first;
  Parts second;
};

/// The whole collision by parts: equations 5 and 6 along the normal with restitution e, the tangential
/// parts as they were. Masses positive, at most one infinite.
constexpr CollidedParts collide_parts(double m1, Parts v1, double m2, Parts v2, double restitution = 1) noexcept {
  const LineVelocities after = collide_on_line(m1, v1.normal, m2, v2.normal, restitution);
  return {{after.v1, v1.tangential}, {after.v2, v2.tangential}};
}

}  // namespace carom::rule
