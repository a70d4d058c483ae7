// How a collision is laid out: what is drawn where and how large, before any pixel.
#pragma once

#include <array>

#include "carom/base/vec2.hpp"
#include "carom/draw/collision.hpp"

namespace carom::draw {

/// A disk as drawn: lengths in mean drawn radii, y upwards, the point of contact at the origin.
struct ViewDisk {
  Vec2 centre;
  double radius = 1;
  Vec2 before;  ///< velocities as arrows
  Vec2 after;
};

/// One layout for all panels, so that disks and arrows can be compared between them.
struct CollisionView {
  std::array<ViewDisk, 2> disks;
  Vec2 normal;   ///< unit vector from centre 1 to centre 2
  Vec2 tangent;  ///< the normal turned to the left
  std::array<Vec2, 2> normal_line;
  std::array<Vec2, 2> tangent_line;
  bool radii_to_scale = true;  ///< false: the larger disk is drawn smaller than it is
  double speed_scale = 0;      ///< the largest speed (length/time); 0 if nothing moves
  Vec2 low, high;              ///< corners of what is drawn
};

/// The caller guarantees finite numbers, positive radii and different centres.
CollisionView view_of(const CollisionPicture& collision);

}  // namespace carom::draw
