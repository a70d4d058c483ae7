#include "ink.hpp"

#include <algorithm>
#include <cmath>

#include "carom/state/system.hpp"

namespace carom::draw {
namespace {

void set_dash(cairo_t* ink, const Pen& pen) {
  constexpr std::array<double, 2> kDashed{6, 4};
  constexpr std::array<double, 2> kDotted{1.5, 3};
  switch (pen.dash) {
    case Dash::solid: return cairo_set_dash(ink, nullptr, 0, 0);
    case Dash::dashed: return cairo_set_dash(ink, kDashed.data(), 2, 0);
    case Dash::dotted: return cairo_set_dash(ink, kDotted.data(), 2, 0);
  }
}

void trace_circle(cairo_t* ink, Vec2 centre, double radius) {
  cairo_new_sub_path(ink);
  cairo_arc(ink, centre.x, centre.y, radius, 0, 2 * kPi);
  cairo_close_path(ink);
}

}  // namespace

Colour viridis(double share) noexcept {
  constexpr std::array<unsigned, 9> kStops{0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c,
                                           0x28ae80, 0x5ec962, 0xaddc30, 0xfde725};
  const double place = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto below = std::min<std::size_t>(static_cast<std::size_t>(place), kStops.size() - 2);
  return mix(colour_from_hex(kStops[below + 1]), colour_from_hex(kStops[below]), place - static_cast<double>(below));
}

Colour readable_on(Colour background) noexcept {
  const double lightness = 0.3 * background.red + 0.59 * background.green + 0.11 * background.blue;
  return lightness > 0.5 ? kBlack : kWhite;
}

void set_colour(cairo_t* ink, Colour colour) { cairo_set_source_rgb(ink, colour.red, colour.green, colour.blue); }

void stroke_path(cairo_t* ink, const Pen& pen) {
  set_colour(ink, pen.colour);
  set_dash(ink, pen);
  cairo_set_line_width(ink, pen.width);
  cairo_stroke(ink);
}

void draw_line(cairo_t* ink, Vec2 from, Vec2 to, const Pen& pen) {
  cairo_move_to(ink, from.x, from.y);
  cairo_line_to(ink, to.x, to.y);
  stroke_path(ink, pen);
}

void draw_circle(cairo_t* ink, Vec2 centre, double radius, const Pen& pen) {
  trace_circle(ink, centre, radius);
  stroke_path(ink, pen);
}

void fill_circle(cairo_t* ink, Vec2 centre, double radius, Colour colour) {
  trace_circle(ink, centre, radius);
  set_colour(ink, colour);
  cairo_fill(ink);
}

void fill_rect(cairo_t* ink, const Rect& rect, Colour colour) {
  cairo_rectangle(ink, rect.left, rect.top, rect.width(), rect.height());
  set_colour(ink, colour);
  cairo_fill(ink);
}

void draw_rect(cairo_t* ink, const Rect& rect, const Pen& pen) {
  cairo_rectangle(ink, rect.left, rect.top, rect.width(), rect.height());
  stroke_path(ink, pen);
}

void draw_arrow(cairo_t* ink, Vec2 from, Vec2 to, const Pen& pen) {
  const double size = length(to - from);
  if (!(size > 0)) return;
  const Vec2 along = (to - from) / size;
  const Vec2 across{-along.y, along.x};
  const double head = std::min(5 * pen.width, 0.7 * size);
  const Vec2 neck = to - head * along;
  draw_line(ink, from, neck + 0.1 * head * along, pen);
  const Vec2 left = neck + 0.4 * head * across;
  const Vec2 right = neck - 0.4 * head * across;
  cairo_move_to(ink, to.x, to.y);
  cairo_line_to(ink, left.x, left.y);
  cairo_line_to(ink, right.x, right.y);
  cairo_close_path(ink);
  set_colour(ink, pen.colour);
  cairo_fill(ink);
}

}  // namespace carom::draw
