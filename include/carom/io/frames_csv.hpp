// Frames as a table.
#pragma once

#include <string>

#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// The header line of such a table: time,id,x,y,vx,vy,winding_x,winding_y,radius,mass.
std::string frames_csv_head();

/// A row for every disk, numbers with 17 significant digits.
std::string frame_csv(const System& system, const Frame& frame);

}  // namespace carom
