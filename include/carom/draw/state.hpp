// All disks at one time as a picture.
#pragma once

#include <optional>
#include <string>

#include "carom/draw/format.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// What the colour of a disk tells.
enum class ColourBy {
  species,  ///< its kind: radius and mass
  speed,    ///< |v|, with a colour bar
  psi6,    ///< the angle of local bond-orientational order ψ6 as a hue, |ψ6| as its strength, with a wheel of colours
  density  ///< its area over that of its Voronoi cell, with a colour bar
};

/// What pictures of one film share: the part of the plane that open axes show, and what colours and arrows stand for.
struct SharedScale {
  Vec2 low, high;  ///< of all disks (length)
  double largest_speed = 0;
  double least_density = 0, greatest_density = 0;  ///< between which densities are told apart
  bool empty = true;
};

/// How a state is drawn.
struct StatePicture {
  ColourBy colour = ColourBy::species;
  bool velocities = false;                 ///< an arrow on each disk
  double width_px = 1000;                  ///< of the picture, from 200 to 8,000; a tall box makes it narrower
  std::string title;                       ///< none if empty
  std::optional<SharedScale> shared = {};  ///< from the one state if absent
};

/// Widens `scale` by what a picture of this state needs. Throws Error where picture_of_state() does.
void include_in_scale(const System& system, const Frame& frame, const StatePicture& picture, SharedScale& scale);

/// The picture's bytes, to be written to a file: the box with walls (thick lines) or periodic edges (dashed), the disks
/// with their images across periodic edges, a scale bar and the time. An axis without walls shows where the disks are.
/// The same state gives the same bytes. Throws Error if there are no disks, frame and system differ in their number, a
/// position or velocity is not finite, or the width is out of range, and for ψ6 and density where local_order() does.
/// Pictures that share a scale have one size for one system.
std::string picture_of_state(const System& system, const Frame& frame, const StatePicture& picture,
                             PictureFormat format);

}  // namespace carom
