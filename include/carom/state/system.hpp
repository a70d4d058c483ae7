// What a run never changes: the box, the walls, the disks' radii and masses, the physics.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "carom/base/vec2.hpp"

namespace carom {

/// What happens where the box ends along one axis.
enum class Boundary {
  periodic,    ///< what leaves on one side enters on the other
  reflecting,  ///< walls at 0 and at the box's size
  open         ///< nothing there: the plane goes on
};

std::string_view name_of(Boundary boundary) noexcept;

/// The box from (0, 0) to `size` (length). Along an open axis `size` bounds nothing; it says how large the
/// region is that a packing fraction refers to, and may be 0 where there is none.
struct Box {
  Vec2 size;
  std::array<Boundary, 2> boundary{Boundary::periodic, Boundary::periodic};  ///< along x, along y

  [[nodiscard]] bool periodic(int axis) const noexcept { return boundary[axis] == Boundary::periodic; }
  [[nodiscard]] bool reflecting(int axis) const noexcept { return boundary[axis] == Boundary::reflecting; }
  /// Momentum along an axis is conserved where no wall takes it up.
  [[nodiscard]] bool conserves_momentum(int axis) const noexcept { return !reflecting(axis); }
  [[nodiscard]] int conserved_axes() const noexcept { return conserves_momentum(0) + conserves_momentum(1); }
  [[nodiscard]] bool has_walls() const noexcept { return reflecting(0) || reflecting(1); }
};

/// A kind of disk.
struct Species {
  double radius = 0.5;  ///< length
  double mass = 1;      ///< in the scene's own unit

  friend bool operator==(const Species&, const Species&) = default;
};

/// How disks collide.
struct Physics {
  double restitution = 1;       ///< e of two disks, in [0, 1]
  double wall_restitution = 1;  ///< e of a disk and a wall, in [0, 1]
  /// Where e < 1: a contact within this time of either disk's last one is elastic (the TC rule of Luding and
  /// McNamara, Granular Matter 1, 113 (1998)), so that no infinite sequence of collisions fits into a finite time.
  double t_c = 0;

  [[nodiscard]] bool elastic() const noexcept { return restitution == 1 && wall_restitution == 1; }
};

/// Everything constant about a simulation. Disk k is of kind species[species_of[k]].
struct System {
  Box box;
  Physics physics;
  std::vector<Species> species;
  std::vector<std::uint32_t> species_of;

  [[nodiscard]] std::size_t size() const noexcept { return species_of.size(); }
  [[nodiscard]] const Species& species_of_disk(std::size_t k) const noexcept { return species[species_of[k]]; }
  [[nodiscard]] double radius(std::size_t k) const noexcept { return species_of_disk(k).radius; }
  [[nodiscard]] double mass(std::size_t k) const noexcept { return species_of_disk(k).mass; }
  [[nodiscard]] double largest_radius() const noexcept;

  /// Adds a disk of this kind; equal kinds share one entry of `species`.
  void add_disk(const Species& kind);

 private:
  /// Bits of (radius, mass) → index into species. Bits, because a NaN has no place in an order of numbers.
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint32_t> index_of_kind_;
};

/// Area covered by the disks over the area of the box; 0 where the box has no area.
double packing_fraction(const System& system) noexcept;

/// Degrees of freedom of the velocities: 2N minus the number of axes along which momentum is conserved.
inline double degrees_of_freedom(const System& system) noexcept {
  return 2 * static_cast<double>(system.size()) - system.box.conserved_axes();
}

/// The circle constant, to the nearest double.
inline constexpr double kPi = 3.141592653589793;

}  // namespace carom
