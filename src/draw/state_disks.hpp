// The disks of a state, with their copies across periodic edges, arrows and ids.
#pragma once

#include <cairo.h>

#include "carom/state/state.hpp"
#include "carom/state/system.hpp"
#include "state_colours.hpp"
#include "state_view.hpp"

namespace carom::draw {

/// Draws inside the view's area only. Disks of less than 3 pixels have no outline; up to 200 have their ids inside.
void draw_disks(cairo_t* ink, const System& system, const Frame& frame, const StateView& view,
                const StateColours& colours);

}  // namespace carom::draw
