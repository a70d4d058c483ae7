// Is there anything left to happen?
#pragma once

#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// True if it is certain that no two disks will ever collide again: nothing moves, there is one disk, or along an
/// open axis no two disks will come near each other any more. False says nothing. O(N²) where an axis is open.
bool collisions_are_over(const System& system, const Frame& frame) noexcept;

}  // namespace carom
