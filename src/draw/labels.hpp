// Finding places for labels where they cover neither lines nor each other.
#pragma once

#include <cairo.h>

#include <vector>

#include "ink.hpp"
#include "rect.hpp"
#include "text.hpp"

namespace carom::draw {

/// A place that a label could take, and how much it is disliked to begin with.
struct LabelPlace {
  Vec2 centre;
  double dislike = 0;
};

struct Label {
  RichText text;
  double size = 14;
  Colour colour;
  Vec2 extent;                     ///< width and height of the text
  std::vector<LabelPlace> places;  ///< at least one
};

Label make_label(cairo_t* ink, RichText text, double size, Colour colour);

/// Places in rings around `point`, nearest first: the label's box clears `distance`. The first direction is `towards`,
/// the dislike grows with the angle to it.
void offer_places_around(Label& label, Vec2 point, double distance, Vec2 towards, double dislike);

/// Places on both sides of the line between two points, from `from`'s end to `to`'s.
void offer_places_along(Label& label, Vec2 from, Vec2 to, double dislike);

/// What labels should not cover: lines and circles, each with a weight.
struct Obstacles {
  struct Line {
    Vec2 from, to;
    double weight;
  };
  struct Circle {
    Vec2 centre;
    double radius;
    double weight;
  };
  Rect area;  ///< labels stay inside
  std::vector<Line> lines;
  std::vector<Circle> circles;
};

/// Draws each label at the place that covers least, taking the others into account.
void draw_labels(cairo_t* ink, const std::vector<Label>& labels, const Obstacles& obstacles);

}  // namespace carom::draw
