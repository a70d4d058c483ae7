// A disk that may be met.
#pragma once

#include "carom/window/collision.hpp"
#include "record.hpp"

namespace carom::fast {

/// Which disk, and which copy of it: with i the pair's smaller id, j's copy at its position + image L.
struct Neighbour {
  Index disk = 0;
  Image image;
};

}  // namespace carom::fast
