// All disks at one time as a picture.
#pragma once

#include <string>

#include "carom/draw/format.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// What the colour of a disk tells.
enum class ColourBy {
  species,  ///< its kind: radius and mass
  speed     ///< |v|, with a colour bar
};

/// How a state is drawn.
struct StatePicture {
  ColourBy colour = ColourBy::species;
  bool velocities = false;  ///< an arrow on each disk
  double width_px = 1000;   ///< of the picture, from 200 to 8,000; a tall box makes it narrower
  std::string title;        ///< none if empty
};

/// The picture's bytes, to be written to a file: the box with walls (thick lines) or periodic edges (dashed), the disks
/// with their images across periodic edges, a scale bar and the time. An axis without walls shows where the disks are.
/// The same state gives the same bytes. Throws Error if there are no disks, frame and system differ in their number, a
/// position or velocity is not finite, or the width is out of range.
std::string picture_of_state(const System& system, const Frame& frame, const StatePicture& picture,
                             PictureFormat format);

}  // namespace carom
