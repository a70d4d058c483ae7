// One collision as a picture: the two disks, their normal and tangent lines, velocities before and after.
#pragma once

#include <string>

#include "carom/base/vec2.hpp"
#include "carom/draw/format.hpp"

namespace carom {

/// A collision to be drawn. All numbers finite, but a mass may be infinite.
struct CollisionPicture {
  struct Disk {
    Vec2 position;      ///< of the centre at contact (length)
    Vec2 before;        ///< velocity before the collision (length/time)
    Vec2 after;         ///< velocity after it; not looked at where the disks do not approach
    double radius = 0;  ///< length; half the distance of the centres where none was given
    double mass = 1;
  };
  Disk first;
  Disk second;
  double restitution = 1;
  bool approaching = true;  ///< false: they do not collide, and the picture says so
};

/// The picture's bytes, to be written to a file: three panels (before; parts along normal and tangent; after) above
/// the numbers. Arrows share one scale in all panels. The same picture gives the same bytes.
/// Throws Error if a number is not finite, a radius or mass not positive, or the centres coincide.
std::string picture_of_collision(const CollisionPicture& collision, PictureFormat format);

}  // namespace carom
