// Which part of the plane a picture of a state shows, and where its pixels are.
#pragma once

#include "carom/base/vec2.hpp"
#include "carom/draw/state.hpp"
#include "rect.hpp"

namespace carom::draw {

/// The region shown, and the rectangle of pixels it is shown in.
struct StateView {
  Vec2 middle;          ///< of the region (length)
  Vec2 half;            ///< half its width and height (length)
  Rect area;            ///< pixels
  double scale = 1;     ///< pixels per length
  double spacing = 1;   ///< pixels: side of the square that each disk has on average
  double fastest = 0;   ///< the largest speed of this picture, or of those that share a scale
  double velocity = 0;  ///< pixels of an arrow per length/time; 0 where none are drawn

  [[nodiscard]] Vec2 pixel(Vec2 p) const noexcept {
    return {area.centre().x + scale * (p.x - middle.x), area.centre().y - scale * (p.y - middle.y)};
  }
};

/// The box along periodic and reflecting axes; the disks, and their arrows if these are drawn, along open ones.
/// The area begins at (`margin`, `top`) and is at most `width_px` − 2 `margin` wide; a tall region is drawn narrower.
/// The caller guarantees at least one disk and finite numbers.
StateView view_of(const System& system, const Frame& frame, const StatePicture& picture, double margin, double top);

/// The largest |v|.
double largest_speed(const Frame& frame) noexcept;

}  // namespace carom::draw
