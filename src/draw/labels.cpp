#include "labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "carom/state/system.hpp"

namespace carom::draw {
namespace {

constexpr double kMargin = 3;          // pixels kept free around a label
constexpr double kOutsideWeight = 50;  // per pixel outside the area
constexpr double kOverlapWeight = 2;   // per square pixel shared with another label
constexpr int kSweeps = 6;

Vec2 turned(Vec2 v, double angle) {
  return {std::cos(angle) * v.x - std::sin(angle) * v.y, std::sin(angle) * v.x + std::cos(angle) * v.y};
}

// Distance from a box's centre to its rim in direction `d`.
double reach(Vec2 extent, Vec2 d) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double x = d.x == 0 ? kNever : 0.5 * extent.x / std::abs(d.x);
  const double y = d.y == 0 ? kNever : 0.5 * extent.y / std::abs(d.y);
  return std::min(x, y);
}

// Length of the line inside the rectangle (Liang and Barsky's clipping).
double length_inside(const Obstacles::Line& line, const Rect& rect) {
  const Vec2 d = line.to - line.from;
  double enter = 0, leave = 1;
  const auto clip = [&](double start, double step, double low, double high) {
    if (step == 0) {
      if (start < low || start > high) leave = -1;
      return;
    }
    const double a = (low - start) / step, b = (high - start) / step;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  };
  clip(line.from.x, d.x, rect.left, rect.right);
  clip(line.from.y, d.y, rect.top, rect.bottom);
  return leave > enter ? (leave - enter) * length(d) : 0;
}

bool rim_crosses(const Obstacles::Circle& circle, const Rect& rect) {
  const Vec2 c = circle.centre;
  const Vec2 nearest{std::clamp(c.x, rect.left, rect.right), std::clamp(c.y, rect.top, rect.bottom)};
  const Vec2 farthest{std::max(c.x - rect.left, rect.right - c.x), std::max(c.y - rect.top, rect.bottom - c.y)};
  return length(nearest - c) < circle.radius && circle.radius < length(farthest);
}

double shared_area(const Rect& a, const Rect& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0 && height > 0 ? width * height : 0;
}

double pixels_outside(const Rect& rect, const Rect& area) {
  return std::max(0.0, area.left - rect.left) + std::max(0.0, rect.right - area.right) +
         std::max(0.0, area.top - rect.top) + std::max(0.0, rect.bottom - area.bottom);
}

double cover(const Rect& rect, const Obstacles& obstacles) {
  double sum = kOutsideWeight * pixels_outside(rect, obstacles.area);
  for (const Obstacles::Line& line : obstacles.lines) sum += line.weight * length_inside(line, rect);
  for (const Obstacles::Circle& circle : obstacles.circles) {
    if (rim_crosses(circle, rect)) sum += circle.weight;
  }
  return sum;
}

Rect box_at(const Label& label, const LabelPlace& place) {
  return rect_around(place.centre, label.extent).grown(kMargin);
}

// The place of label `k` that costs least while all others stay; those not yet placed are empty boxes.
std::size_t best_place(const std::vector<Label>& labels, std::size_t k, const std::vector<Rect>& taken,
                       const Obstacles& obstacles) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t candidate = 0; candidate < labels[k].places.size(); ++candidate) {
    const Rect box = box_at(labels[k], labels[k].places[candidate]);
    double cost = labels[k].places[candidate].dislike + cover(box, obstacles);
    for (std::size_t other = 0; other < labels.size(); ++other) {
      if (other != k) cost += kOverlapWeight * shared_area(box, taken[other]);
    }
    if (cost < least) {
      least = cost;
      best = candidate;
    }
  }
  return best;
}

}  // namespace

Label make_label(cairo_t* ink, RichText text, double size, Colour colour) {
  const Vec2 extent = measure(ink, text, size);
  return {std::move(text), size, colour, extent, {}};
}

void offer_places_around(Label& label, Vec2 point, double distance, Vec2 towards, double dislike) {
  constexpr int kDirections = 24;
  constexpr std::array<double, 4> kRings{0, 8, 18, 30};  // pixels farther out
  for (const double ring : kRings) {
    for (int step = 0; step < kDirections; ++step) {
      const double angle = (step % 2 == 0 ? 1 : -1) * ((step + 1) / 2) * 2 * kPi / kDirections;
      const Vec2 d = turned(towards, angle);
      const double away = distance + ring + reach(label.extent, d);
      label.places.push_back({point + away * d, dislike + ring + 4 * std::abs(angle)});
    }
  }
}

void offer_places_along(Label& label, Vec2 from, Vec2 to, double dislike) {
  const double size = length(to - from);
  if (!(size > 0)) return;
  const Vec2 along = (to - from) / size;
  for (const double share : {0.9, 0.75, 0.6, 0.45, 0.3, 0.15}) {
    for (const Vec2 side : {Vec2{-along.y, along.x}, Vec2{along.y, -along.x}}) {
      const Vec2 foot = from + share * (to - from);
      label.places.push_back({foot + (5 + reach(label.extent, side)) * side, dislike + 10 * (1 - share)});
    }
  }
}

void draw_labels(cairo_t* ink, const std::vector<Label>& labels, const Obstacles& obstacles) {
  std::vector<Rect> taken(labels.size());
  std::vector<std::size_t> place(labels.size());
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t k = 0; k < labels.size(); ++k) {
      place[k] = best_place(labels, k, taken, obstacles);
      taken[k] = box_at(labels[k], labels[k].places[place[k]]);
    }
  }
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const Label& label = labels[k];
    draw_text_around(ink, label.text, label.places[place[k]].centre, label.size, label.colour);
  }
}

}  // namespace carom::draw
