#include "state_disks.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "text.hpp"

namespace carom::draw {
namespace {

constexpr double kOutlined = 3;            // pixels of radius: smaller disks have no outline
constexpr double kLeastVisible = 1.2;      // pixels of radius: smaller ones are drawn larger …
constexpr double kSpacingShare = 0.3;      // … but not so large that they would fill the plane
constexpr double kGreatestRadius = 1e5;    // pixels: no picture is wider, and Cairo's arcs stay short of overflow
constexpr std::size_t kMostWithIds = 200;  // disks
constexpr double kLeastIdSize = 6;         // pixels
constexpr double kGreatestIdSize = 16;     // pixels
constexpr std::size_t kDotsPerStroke = 500;

// A disk or a copy of one, in pixels.
struct Spot {
  Vec2 centre;
  double radius;
};

double drawn_radius(const System& system, std::size_t k, const StateView& view) {
  const double radius = std::min(view.scale * system.radius(k), kGreatestRadius);
  return std::max(radius, std::min(kLeastVisible, kSpacingShare * view.spacing));
}

// Frames made by hand may not be wrapped.
Vec2 wrapped(const Box& box, Vec2 p) {
  return {box.periodic(0) ? wrap(p.x, box.size.x).coordinate : p.x,
          box.periodic(1) ? wrap(p.y, box.size.y).coordinate : p.y};
}

// The disk and its copies across periodic edges, as far as they reach into the area.
void spots_of(const System& system, const Frame& frame, std::size_t k, const StateView& view,
              std::vector<Spot>& spots) {
  spots.clear();
  const Vec2 centre = view.pixel(wrapped(system.box, frame.position(k)));
  const double radius = drawn_radius(system, k, view);
  const int across = system.box.periodic(0) ? 1 : 0, up = system.box.periodic(1) ? 1 : 0;
  for (int x = -across; x <= across; ++x) {
    for (int y = -up; y <= up; ++y) {
      const Vec2 copy = centre + Vec2{x * view.scale * system.box.size.x, y * view.scale * system.box.size.y};
      const Rect reach = view.area.grown(radius);
      const bool seen = copy.x > reach.left && copy.x < reach.right && copy.y > reach.top && copy.y < reach.bottom;
      if (seen) spots.push_back({copy, radius});
    }
  }
}

// Small disks of one colour and radius: dots of a round pen, many in one stroke.
class Dots {
 public:
  Dots(cairo_t* ink, Colour colour) : ink_(ink), colour_(colour) {}
  ~Dots() { stroke(); }
  Dots(const Dots&) = delete;
  Dots& operator=(const Dots&) = delete;

  void add(const Spot& spot) {
    if (spot.radius != radius_ || count_ == kDotsPerStroke) stroke();
    radius_ = spot.radius;
    ++count_;
    cairo_move_to(ink_, spot.centre.x, spot.centre.y);
    cairo_close_path(ink_);
  }

 private:
  void stroke() {
    if (count_ == 0) return;
    set_colour(ink_, colour_);
    cairo_set_dash(ink_, nullptr, 0, 0);
    cairo_set_line_width(ink_, 2 * radius_);
    cairo_stroke(ink_);
    count_ = 0;
  }

  cairo_t* ink_;
  Colour colour_;
  double radius_ = 0;
  std::size_t count_ = 0;
};

// Disks in order of their class, and in id order within it.
std::vector<std::uint32_t> by_class(const StateColours& colours) {
  std::vector<std::uint32_t> start(colours.classes.size() + 1, 0);
  for (const std::uint32_t kind : colours.class_of) ++start[kind + 1];
  for (std::size_t kind = 1; kind < start.size(); ++kind) start[kind] += start[kind - 1];
  std::vector<std::uint32_t> order(colours.class_of.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[start[colours.class_of[k]]++] = k;
  return order;
}

void draw_outlined(cairo_t* ink, const Spot& spot, Colour colour) {
  fill_circle(ink, spot.centre, spot.radius, colour);
  const double width = std::clamp(0.08 * spot.radius, 0.5, 1.5);
  draw_circle(ink, spot.centre, spot.radius - 0.5 * width, {mix(colour, kBlack, 0.6), width});
}

void draw_bodies(cairo_t* ink, const System& system, const Frame& frame, const StateView& view,
                 const StateColours& colours) {
  const std::vector<std::uint32_t> order = by_class(colours);
  std::vector<Spot> spots;
  for (std::size_t place = 0; place < order.size();) {
    const std::uint32_t kind = colours.class_of[order[place]];
    Dots dots(ink, colours.classes[kind]);
    for (; place < order.size() && colours.class_of[order[place]] == kind; ++place) {
      spots_of(system, frame, order[place], view, spots);
      for (const Spot& spot : spots) {
        if (spot.radius < kOutlined) {
          dots.add(spot);
        } else {
          draw_outlined(ink, spot, colours.classes[kind]);
        }
      }
    }
  }
}

void draw_velocities(cairo_t* ink, const System& system, const Frame& frame, const StateView& view) {
  for (std::size_t k = 0; k < frame.size(); ++k) {
    const Vec2 from = view.pixel(wrapped(system.box, frame.position(k)));
    const Vec2 step{view.velocity * frame.vx[k], -view.velocity * frame.vy[k]};
    const double size = length(step);
    const double width = std::clamp(0.05 * view.spacing, 0.6, 2.2);
    if (size > 6) {
      draw_arrow(ink, from, from + step, {kBlack, width});
    } else if (size > 0.5) {
      draw_line(ink, from, from + step, {kBlack, width});
    }
  }
}

// `p` moved into the area so far that a text of this size around it is seen whole.
Vec2 kept_inside(Vec2 p, const Rect& area, Vec2 size) {
  const Vec2 room{std::max(0.0, 0.5 * (area.width() - size.x)), std::max(0.0, 0.5 * (area.height() - size.y))};
  const Vec2 middle = area.centre();
  return {std::clamp(p.x, middle.x - room.x, middle.x + room.x), std::clamp(p.y, middle.y - room.y, middle.y + room.y)};
}

// Inside the disk; where arrows are drawn, on the side that the arrow leaves free.
void draw_ids(cairo_t* ink, const System& system, const Frame& frame, const StateView& view,
              const StateColours& colours) {
  for (std::size_t k = 0; k < frame.size(); ++k) {
    const RichText text = RichText{}.plain(std::to_string(k));
    const double radius = view.scale * system.radius(k);
    const bool moving = view.velocity * std::hypot(frame.vx[k], frame.vy[k]) > 1;
    const double width_of_unit_size = measure(ink, text, 1).x;
    const double room = (moving ? 0.9 : 1.5) * radius;
    const double size = std::min({kGreatestIdSize, 0.9 * radius, room / width_of_unit_size});
    if (size < kLeastIdSize) continue;
    const Vec2 v = frame.velocity(k);
    const Vec2 back = moving ? 0.5 * radius / std::hypot(v.x, v.y) * Vec2{-v.x, v.y} : Vec2{};
    const Vec2 centre = view.pixel(wrapped(system.box, frame.position(k)));
    const Vec2 place = kept_inside(centre + back, view.area, {size * width_of_unit_size + 4, size + 4});
    draw_text_around(ink, text, place, size, readable_on(colours.classes[colours.class_of[k]]));
  }
}

}  // namespace

void draw_disks(cairo_t* ink, const System& system, const Frame& frame, const StateView& view,
                const StateColours& colours) {
  cairo_save(ink);
  cairo_rectangle(ink, view.area.left, view.area.top, view.area.width(), view.area.height());
  cairo_clip(ink);
  cairo_set_line_cap(ink, CAIRO_LINE_CAP_ROUND);
  draw_bodies(ink, system, frame, view, colours);
  cairo_set_line_cap(ink, CAIRO_LINE_CAP_BUTT);
  if (view.velocity > 0) draw_velocities(ink, system, frame, view);
  if (frame.size() <= kMostWithIds) draw_ids(ink, system, frame, view, colours);
  cairo_restore(ink);
}

}  // namespace carom::draw
