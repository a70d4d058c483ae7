// Rectangles on the canvas: pixels, y downwards.
#pragma once

#include "carom/base/vec2.hpp"

namespace carom::draw {

struct Rect {
  double left = 0, top = 0, right = 0, bottom = 0;

  [[nodiscard]] constexpr double width() const noexcept { return right - left; }
  [[nodiscard]] constexpr double height() const noexcept { return bottom - top; }
  [[nodiscard]] constexpr Vec2 centre() const noexcept { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
  /// Larger by `margin` on every side.
  [[nodiscard]] constexpr Rect grown(double margin) const noexcept {
    return {left - margin, top - margin, right + margin, bottom + margin};
  }
};

constexpr Rect rect_around(Vec2 centre, Vec2 size) noexcept {
  return {centre.x - 0.5 * size.x, centre.y - 0.5 * size.y, centre.x + 0.5 * size.x, centre.y + 0.5 * size.y};
}

}  // namespace carom::draw
