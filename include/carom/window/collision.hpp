// One event of the trajectory, and the order in which events stand.
#pragma once

#include <cstdint>
#include <string_view>
#include <tuple>

#include "carom/base/vec2.hpp"

namespace carom {

using DiskId = std::uint32_t;

/// The walls of a reflecting box, in the order of their ids.
enum class Wall : std::uint32_t { left, right, bottom, top };

/// Walls have ids above all disks.
inline constexpr DiskId kFirstWallId = UINT32_MAX - 3;

constexpr DiskId id_of(Wall wall) noexcept { return kFirstWallId + static_cast<DiskId>(wall); }
constexpr bool is_wall(DiskId id) noexcept { return id >= kFirstWallId; }
constexpr Wall wall_of(DiskId id) noexcept { return static_cast<Wall>(id - kFirstWallId); }
/// 0 for left and right, 1 for bottom and top.
constexpr int axis_of(Wall wall) noexcept { return static_cast<int>(wall) / 2; }

std::string_view name_of(Wall wall) noexcept;

/// Which periodic copy of disk j meets disk i: j's stored position + (x Lx, y Ly). Zero for walls.
struct Image {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend constexpr auto operator<=>(const Image&, const Image&) = default;
};

/// A contact of disk i with disk j > i or with a wall.
struct Collision {
  double time = 0;  ///< since the window's start
  /// 0, or one more than the largest generation of the two disks' previous events at this same time.
  std::uint32_t generation = 0;
  DiskId i = 0;
  DiskId j = 0;  ///< a disk, or id_of(Wall)
  Image image;
  Vec2 point;          ///< of contact (length): on disk i's rim, seen from i's wrapped centre
  Vec2 normal;         ///< unit vector from i to j, or to the wall
  double impulse = 0;  ///< |J| (mass × length/time)
};

/// The order of the collision log: (time, generation, i, j, image). Total: no two events of a window are equal.
constexpr bool stands_before(const Collision& a, const Collision& b) noexcept {
  return std::tie(a.time, a.generation, a.i, a.j, a.image) < std::tie(b.time, b.generation, b.i, b.j, b.image);
}

}  // namespace carom
