// Colours, and the few shapes that pictures are made of. Lengths in pixels, y downwards.
#pragma once

#include <cairo.h>

#include <array>

#include "carom/base/vec2.hpp"
#include "rect.hpp"

namespace carom::draw {

struct Colour {
  double red = 0, green = 0, blue = 0;
};

constexpr Colour colour_from_hex(unsigned rgb) noexcept {
  return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0};
}

/// `share` of `a`, the rest of `b`.
constexpr Colour mix(Colour a, Colour b, double share) noexcept {
  return {share * a.red + (1 - share) * b.red, share * a.green + (1 - share) * b.green,
          share * a.blue + (1 - share) * b.blue};
}

// The palette of Okabe and Ito, told apart by colour-blind readers.
inline constexpr Colour kOrange = colour_from_hex(0xE69F00);
inline constexpr Colour kSkyBlue = colour_from_hex(0x56B4E9);
inline constexpr Colour kGreen = colour_from_hex(0x009E73);
inline constexpr Colour kYellow = colour_from_hex(0xF0E442);
inline constexpr Colour kBlue = colour_from_hex(0x0072B2);
inline constexpr Colour kVermilion = colour_from_hex(0xD55E00);
inline constexpr Colour kPurple = colour_from_hex(0xCC79A7);
inline constexpr Colour kBlack{};
inline constexpr Colour kWhite{1, 1, 1};
inline constexpr Colour kDarkGrey = colour_from_hex(0x404040);
inline constexpr Colour kGrey = colour_from_hex(0x808080);
inline constexpr Colour kLightGrey = colour_from_hex(0xD0D0D0);

/// Colour of `share` in [0, 1] on the scale viridis, from dark violet to yellow; evenly graded in lightness.
Colour viridis(double share) noexcept;

/// Black or white, whichever can be read better on `background`.
Colour readable_on(Colour background) noexcept;

void set_colour(cairo_t* ink, Colour colour);

enum class Dash { solid, dashed, dotted };

struct Pen {
  Colour colour;
  double width = 1;
  Dash dash = Dash::solid;
};

/// Strokes the current path.
void stroke_path(cairo_t* ink, const Pen& pen);
void draw_line(cairo_t* ink, Vec2 from, Vec2 to, const Pen& pen);
void draw_circle(cairo_t* ink, Vec2 centre, double radius, const Pen& pen);
void fill_circle(cairo_t* ink, Vec2 centre, double radius, Colour colour);
void fill_rect(cairo_t* ink, const Rect& rect, Colour colour);
void draw_rect(cairo_t* ink, const Rect& rect, const Pen& pen);
/// A line with a head at `to`; the head shrinks with a short arrow. Draws nothing where both ends coincide.
void draw_arrow(cairo_t* ink, Vec2 from, Vec2 to, const Pen& pen);

}  // namespace carom::draw
