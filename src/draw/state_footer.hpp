// The lines below a picture of a state: time, counts, scale bar, what the colours mean.
#pragma once

#include <cairo.h>

#include <vector>

#include "carom/draw/state.hpp"
#include "state_colours.hpp"
#include "state_view.hpp"
#include "text.hpp"

namespace carom::draw {

/// One thing in the footer: text, with a swatch or bar before it.
struct FooterItem {
  enum class Kind { text, scale_bar, arrow, swatch, shades };
  Kind kind = Kind::text;
  RichText text;
  double lead = 0;         ///< pixels of what is drawn before the text
  Colour colour{};         ///< of a swatch
  double least_width = 0;  ///< of the text (pixels)
  Vec2 place{};            ///< of its left end on the baseline, from the footer's top left
};

/// Items laid out in lines that fit the width.
struct Footer {
  std::vector<FooterItem> items;
  bool wheel = false;  ///< of colours, at the right end
  double height = 0;
};

/// What there is to say, laid out in lines of at most `width` pixels; `ink` measures.
Footer footer_of(cairo_t* ink, const System& system, const Frame& frame, const StatePicture& picture,
                 const StateView& view, const StateColours& colours, double width);

/// `width` as it was laid out for.
void draw_footer(cairo_t* ink, const Footer& footer, Vec2 top_left, double width, const StateColours& colours);

}  // namespace carom::draw
