#include "state_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::draw {
namespace {

constexpr double kGreatestHeight = 1.25;  // of the picture's width
constexpr double kOpenMargin = 1.06;      // of the disks' extent, along open axes
constexpr double kThinnest = 1e-4;        // of the longer side: a region is never drawn thinner
constexpr double kArrowShare = 0.9;       // of the disks' spacing, for the fastest disk
constexpr double kLongestArrow = 0.2;     // of the region's shorter side

constexpr double kSmallest = 1e-290;  // length: pixels per length stay finite

// What is shown along one axis.
struct Interval {
  double middle = 0;
  double half = 0;
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double a, double b) noexcept {
    low = std::min(low, a);
    high = std::max(high, b);
  }
  // Halves first: neither may overflow.
  [[nodiscard]] double middle() const noexcept { return 0.5 * low + 0.5 * high; }
  [[nodiscard]] double half() const noexcept { return 0.5 * high - 0.5 * low; }
};

double component(Vec2 v, int axis) { return axis == 0 ? v.x : v.y; }

// `reach` is the time that arrows show.
Interval shown_along(const System& system, const Frame& frame, const StatePicture& picture, int axis, double reach) {
  if (system.box.boundary[axis] != Boundary::open) {
    const double half = 0.5 * component(system.box.size, axis);
    return {half, half};
  }
  Range range;
  if (picture.shared) {
    const double arrow = reach * picture.shared->largest_speed;
    range.include(component(picture.shared->low, axis) - arrow, component(picture.shared->high, axis) + arrow);
    return {range.middle(), kOpenMargin * std::max(range.half(), system.largest_radius())};
  }
  for (std::size_t k = 0; k < frame.size(); ++k) {
    const double centre = component(frame.position(k), axis), tip = reach * component(frame.velocity(k), axis);
    range.include(centre - system.radius(k), centre + system.radius(k));
    range.include(centre + tip, centre + tip);
  }
  // Far from the origin rounding can swallow a radius.
  return {range.middle(), kOpenMargin * std::max(range.half(), system.largest_radius())};
}

void set_region(const System& system, const Frame& frame, const StatePicture& picture, double reach, StateView& view) {
  const Interval x = shown_along(system, frame, picture, 0, reach);
  const Interval y = shown_along(system, frame, picture, 1, reach);
  view.middle = {x.middle, y.middle};
  const double longer = std::max({x.half, y.half, kSmallest});
  view.half = {std::max(x.half, kThinnest * longer), std::max(y.half, kThinnest * longer)};
}

// Length of the fastest disk's arrow (length).
double longest_arrow(const System& system, const Frame& frame, const StateView& view) {
  const double spacing = 2 * std::sqrt(view.half.x / static_cast<double>(frame.size())) * std::sqrt(view.half.y);
  const double room = 2 * kLongestArrow * std::max(std::min(view.half.x, view.half.y), system.largest_radius());
  return std::min(std::max(kArrowShare * spacing, 1.5 * system.largest_radius()), room);
}

void set_area(const StatePicture& picture, double margin, double top, StateView& view) {
  const double widest = picture.width_px - 2 * margin;
  const double highest = kGreatestHeight * picture.width_px;
  view.scale = std::min(widest / view.half.x, highest / view.half.y) / 2;
  const double width = std::max(1.0, 2 * view.scale * view.half.x);
  const double height = std::max(1.0, 2 * view.scale * view.half.y);
  view.area = {margin, top, margin + width, top + height};
}

}  // namespace

double largest_speed(const Frame& frame) noexcept {
  double speed = 0;
  for (std::size_t k = 0; k < frame.size(); ++k) speed = std::max(speed, std::hypot(frame.vx[k], frame.vy[k]));
  return speed;
}

StateView view_of(const System& system, const Frame& frame, const StatePicture& picture, double margin, double top) {
  StateView view;
  set_region(system, frame, picture, 0, view);
  view.fastest = picture.shared ? picture.shared->largest_speed : largest_speed(frame);
  const double speed = picture.velocities ? view.fastest : 0;
  const double reach = speed > 0 ? longest_arrow(system, frame, view) / speed : 0;
  if (reach > 0) set_region(system, frame, picture, reach, view);
  set_area(picture, margin, top, view);
  view.spacing = std::sqrt(view.area.width() * view.area.height() / static_cast<double>(frame.size()));
  view.velocity = view.scale * reach;
  return view;
}

}  // namespace carom::draw
