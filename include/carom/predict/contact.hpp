// When do two bodies meet? Pure functions of how they fly; forms that do not cancel.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/base/vec2.hpp"

namespace carom::predict {

/// The time of an event that does not happen.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// Free flight: where a disk was at its own time, and how it moves since.
struct Flight {
  Vec2 position;    ///< at `time` (length)
  Vec2 velocity;    ///< constant until the disk's next event (length/time)
  double time = 0;  ///< of the disk's own last event
};

/// Position at `time`. Exactly `position` at the flight's own time.
constexpr Vec2 position_at(const Flight& flight, double time) noexcept {
  return flight.position + flight.velocity * (time - flight.time);
}

/// Vector from disk i to the copy of disk j that is shifted by `image` (n L, per axis), both at `time`.
/// Every formula that needs it calls this one, so that prediction and collision see the same bits.
constexpr Vec2 separation(const Flight& i, const Flight& j, Vec2 image, double time) noexcept {
  return (position_at(j, time) + image) - position_at(i, time);
}

/// Time at which disks i and j (its copy shifted by `image`) come within `sigma`, the sum of their radii;
/// kNever if they do not. Pairs that touch or overlap and approach meet at max(t_i, t_j). The smaller id is i.
///
/// With r and v the relative position and velocity at t_r = max(t_i, t_j), b = r·v, a = v·v, c = r·r − σ²:
/// t = t_r + c / (−b + √d), d = a σ² − (r × v)². This d equals b² − a c, but loses no digits for distant pairs.
inline double contact_of_disks(const Flight& i, const Flight& j, Vec2 image, double sigma) noexcept {
  const double start = std::max(i.time, j.time);
  const Vec2 r = separation(i, j, image, start);
  const Vec2 v = j.velocity - i.velocity;
  const double b = dot(r, v);
  if (!(b < 0)) return kNever;
  const double c = dot(r, r) - sigma * sigma;
  if (c <= 0) return start;
  const double twist = cross(r, v);
  const double d = dot(v, v) * (sigma * sigma) - twist * twist;
  if (!(d >= 0)) return kNever;
  return start + c / (-b + std::sqrt(d));
}

/// Time at which a disk meets a wall `distance` away from its rim, closing in at `speed`, seen at the disk's own
/// `time`; `time` itself if it is already past the wall and approaching; kNever if it is not approaching.
constexpr double contact_with_wall(double distance, double speed, double time) noexcept {
  if (!(speed > 0)) return kNever;
  if (distance <= 0) return time;
  return time + distance / speed;
}

/// The same for the wall at 0 (left, bottom), from one coordinate of centre and velocity.
constexpr double contact_with_low_wall(double x, double v, double time, double radius) noexcept {
  return contact_with_wall(x - radius, -v, time);
}

/// The same for the wall at `size` (right, top).
constexpr double contact_with_high_wall(double x, double v, double time, double radius, double size) noexcept {
  return contact_with_wall((size - radius) - x, v, time);
}

}  // namespace carom::predict
