// The rows of the collision log.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "carom/window/collision.hpp"

namespace carom {

/// The line above the rows.
inline constexpr std::string_view kCollisionsHead = "time,i,j,x,y,nx,ny,impulse\n";

/// One line for each; `window_start` is the time from which the collisions' own times count.
std::string collision_rows(std::span<const Collision> collisions, double window_start);

}  // namespace carom
