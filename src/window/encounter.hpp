// What happens when two bodies meet inside a window: the same steps, and so the same bits, for every solver.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "carom/predict/contact.hpp"
#include "carom/rule/collision.hpp"
#include "carom/state/system.hpp"
#include "carom/window/collision.hpp"

namespace carom {

/// The copy's offset n L (length).
constexpr Vec2 shift_of(Image image, Vec2 size) noexcept { return {image.x * size.x, image.y * size.y}; }

/// A contact of two disks, both at the time of contact.
struct DiskEncounter {
  Vec2 r;                  ///< from disk i to the copy of disk j that it meets (length)
  rule::Velocities after;  ///< of i and of j
  double impulse = 0;      ///< |J| (mass × length/time)
};

constexpr double kNoContactYet = -predict::kNever;

/// From disk i to the copy of disk j shifted by `shift`, from where both are at contact: predict::separation's bits.
constexpr Vec2 separation_at_contact(Vec2 i, Vec2 j, Vec2 shift) noexcept { return (j + shift) - i; }

/// Disks i and j, `r` apart, have velocities `before`, masses `m_i`, `m_j` and restitution `e`.
[[gnu::always_inline]] inline DiskEncounter encounter_of_disks(Vec2 r, const rule::Velocities& before, double m_i,
                                                               double m_j, double e) noexcept {
  const rule::Velocities after = rule::collide({.r = r, .v = before, .m1 = m_i, .m2 = m_j, .restitution = e});
  return {r, after, length(rule::impulse_on_second(m_j, before, after))};
}

/// The same for disks of one mass. The rule asks for the ratio of the masses only, and a number divided by itself is 1.
[[gnu::always_inline]] inline DiskEncounter encounter_of_equal_disks(Vec2 r, const rule::Velocities& before,
                                                                     double mass, double e) noexcept {
  const rule::Velocities after = rule::collide({.r = r, .v = before, .m1 = 1, .m2 = 1, .restitution = e});
  return {r, after, length(rule::impulse_on_second(mass, before, after))};
}

/// One coordinate of a wall's contact: what the walls of a box need to know about it.
struct WallSide {
  int axis = 0;     ///< 0 for left and right, 1 for bottom and top
  bool low = true;  ///< left or bottom
};

constexpr WallSide side_of(Wall wall) noexcept { return {axis_of(wall), wall == Wall::left || wall == Wall::bottom}; }

/// Time at which a disk of this radius meets the wall; kNever if it does not.
inline double contact_of_disk_and_wall(const predict::Flight& flight, double radius, Wall wall, Vec2 size) noexcept {
  const WallSide side = side_of(wall);
  const double x = side.axis == 0 ? flight.position.x : flight.position.y;
  const double v = side.axis == 0 ? flight.velocity.x : flight.velocity.y;
  return side.low ? predict::contact_with_low_wall(x, v, flight.time, radius)
                  : predict::contact_with_high_wall(x, v, flight.time, radius, side.axis == 0 ? size.x : size.y);
}

/// By how much a disk reaches past a wall, in its diameters; negative if it does not.
inline double overlap_with_wall(Vec2 position, double radius, Wall wall, Vec2 size) noexcept {
  const WallSide side = side_of(wall);
  const double x = side.axis == 0 ? position.x : position.y;
  const double distance = side.low ? x - radius : ((side.axis == 0 ? size.x : size.y) - radius) - x;
  return -distance / (2 * radius);
}

/// The TC rule: is a contact at `time` so soon after the last one of either body that it is elastic?
constexpr bool collapses(double time, double last_contact, double restitution, double t_c) noexcept {
  return restitution != 1 && time - last_contact < t_c;
}

/// The log's row for a contact of disks i and j; `position_i` is i's at contact.
inline Collision row_of_disks(double time, std::uint32_t generation, DiskId i, DiskId j, Image image, Vec2 position_i,
                              double radius_i, const DiskEncounter& encounter) noexcept {
  const Vec2 normal = encounter.r / length(encounter.r);
  return {time, generation, i, j, image, position_i + radius_i * normal, normal, encounter.impulse};
}

/// The log's row for a contact of disk i and a wall.
inline Collision row_of_wall(double time, std::uint32_t generation, DiskId i, Wall wall, Vec2 position, double radius,
                             double impulse) noexcept {
  const WallSide side = side_of(wall);
  const double outwards = side.low ? -1 : 1;
  const Vec2 normal = side.axis == 0 ? Vec2{outwards, 0} : Vec2{0, outwards};
  return {time, generation, i, id_of(wall), {}, position + radius * normal, normal, impulse};
}

}  // namespace carom
