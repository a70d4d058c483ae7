// What the colours of a picture of a state mean.
#pragma once

#include <string>
#include <vector>

#include "carom/draw/state.hpp"
#include "ink.hpp"

namespace carom::draw {

/// The classes of disks that are drawn alike, and what the footer says of them.
struct StateColours {
  std::vector<Colour> classes;          ///< colours, by class
  std::vector<std::uint32_t> class_of;  ///< disk → class

  bool wheel = false;  ///< colours are those of phases, explained by a wheel
  /// Else they are shades of a quantity from `low` to `high` if `quantity` is not empty, else one for each species.
  std::string quantity;
  double low = 0;
  double high = 0;
};

/// By species: a colour each for up to 7; more are shaded by radius, or by mass where all radii are equal. By speed:
/// shades from 0 to the largest |v|. By ψ6: phase_colours(). By density: shades between the two densities that leave
/// out a fiftieth of the disks on either side. Largest speed and densities are those of the shared scale, if there is
/// one.
StateColours colours_of(const System& system, const Frame& frame, const StatePicture& picture);

/// Between which densities the disks' densities are told apart; widens what is there unless it is empty.
void include_densities(std::vector<double> densities, SharedScale& scale);

}  // namespace carom::draw
