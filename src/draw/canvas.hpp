// A white page in memory that Cairo draws on.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>

#include "carom/draw/format.hpp"

namespace carom::draw {

/// A page of `width` × `height` pixels, y downwards. A PNG has `png_scale` dots per pixel; a pixel is 3/4 point in a
/// PDF.
class Canvas {
 public:
  /// Throws Error if Cairo cannot make a page of that size.
  Canvas(PictureFormat format, double width, double height, double png_scale);
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Valid as long as the canvas.
  [[nodiscard]] cairo_t* ink() const noexcept { return ink_.get(); }
  [[nodiscard]] double width() const noexcept { return width_; }
  [[nodiscard]] double height() const noexcept { return height_; }

  /// Ends the page and gives its bytes; nothing may be drawn afterwards. Throws Error with Cairo's reason.
  std::string finish();

 private:
  struct Release {
    void operator()(cairo_surface_t* surface) const noexcept { cairo_surface_destroy(surface); }
    void operator()(cairo_t* ink) const noexcept { cairo_destroy(ink); }
  };

  PictureFormat format_;
  double width_;
  double height_;
  std::string bytes_;  // what Cairo has written so far
  std::unique_ptr<cairo_surface_t, Release> surface_;
  std::unique_ptr<cairo_t, Release> ink_;
};

}  // namespace carom::draw
