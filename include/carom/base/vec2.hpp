// A vector of the plane: the one geometric type of carom.
#pragma once

#include <cfloat>
#include <cmath>

#ifdef __FAST_MATH__
#error "carom gives the same bits everywhere only without -ffast-math"
#endif
static_assert(FLT_EVAL_METHOD == 0, "carom needs arithmetic that rounds every operation to double");

namespace carom {

/// A vector with components along x and y. The unit is that of whatever it holds.
struct Vec2 {
  double x = 0;
  double y = 0;

  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) noexcept { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) noexcept { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) noexcept { return {-a.x, -a.y}; }
constexpr Vec2 operator*(double s, Vec2 a) noexcept { return {s * a.x, s * a.y}; }
constexpr Vec2 operator*(Vec2 a, double s) noexcept { return {a.x * s, a.y * s}; }
constexpr Vec2 operator/(Vec2 a, double s) noexcept { return {a.x / s, a.y / s}; }

/// Scalar product a·b.
constexpr double dot(Vec2 a, Vec2 b) noexcept { return a.x * b.x + a.y * b.y; }

/// z-component of the vector product a × b.
constexpr double cross(Vec2 a, Vec2 b) noexcept { return a.x * b.y - a.y * b.x; }

/// Length |a|. Plain square root of a·a: no scaling against overflow beyond 1e154.
inline double length(Vec2 a) noexcept { return std::sqrt(dot(a, a)); }

}  // namespace carom
