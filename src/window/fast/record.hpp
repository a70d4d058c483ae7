// What the hot loop knows of a disk: one cache line.
#pragma once

#include <cstddef>
#include <cstdint>

#include "carom/predict/contact.hpp"
#include "carom/window/collision.hpp"

namespace carom::fast {

/// Number of a disk inside a window: the disks are loaded in the order of a grid, so that neighbours in space are
/// neighbours in memory. Not the disk's id.
using Index = std::int32_t;

/// Partners that are no disks.
inline constexpr Index kNobody = -1;
inline constexpr Index kGridEvent = -2;  ///< the disk leaves the place where its neighbours were looked for

constexpr Index partner_of(Wall wall) noexcept { return -3 - static_cast<Index>(wall); }
constexpr bool is_wall_partner(Index partner) noexcept { return partner <= -3; }
constexpr Wall wall_of_partner(Index partner) noexcept { return static_cast<Wall>(-3 - partner); }

struct alignas(64) Record {
  double x, y;           ///< position at time `t` (length)
  double vx, vy;         ///< velocity since then (length/time)
  double t;              ///< of the disk's own last event in this window, 0 if it had none (time)
  double radius;         ///< length
  double next;           ///< time of its earliest known event; from the window's end on it does not count
  Index partner;         ///< with whom: a disk's index, a wall's, or one of the above
  std::uint32_t events;  ///< contacts in this window so far

  [[nodiscard]] predict::Flight flight() const noexcept { return {{x, y}, {vx, vy}, t}; }
};
static_assert(sizeof(Record) == 64 && offsetof(Record, vx) == 16 && offsetof(Record, t) == 32 &&
              offsetof(Record, radius) == 40);

}  // namespace carom::fast
