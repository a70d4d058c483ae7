#include "region.hpp"

#include <algorithm>
#include <cmath>

#include "carom/base/error.hpp"

namespace carom {
namespace {

// 2³¹ less a bit, so that rounding stays inside.
constexpr double kMostSteps = 2147483000;
// Copies that the strip around the box may hold, per disk and in all.
constexpr double kMostCopiesPerDisk = 100;
constexpr double kMostCopies = 1e6;
// What an open axis has around its outermost disks, as a share of the cluster's longer side.
constexpr double kOpenMargin = 0.1;

RegionAxis axis_of(const std::vector<double>& coordinates, double size, Boundary boundary) {
  RegionAxis axis;
  axis.periodic = boundary == Boundary::periodic;
  axis.width = size;
  if (boundary == Boundary::open) {
    const auto [low, high] = std::minmax_element(coordinates.begin(), coordinates.end());
    axis.low = *low;
    axis.width = *high - *low;
  }
  return axis;
}

void widen(RegionAxis& axis, double by) noexcept {
  axis.low -= by;
  axis.width += 2 * by;
}

}  // namespace

Step RegionAxis::step_of(double coordinate) const noexcept {
  const double step = std::rint((coordinate - low) * steps_per_length());
  const double period = static_cast<double>(steps);
  if (periodic) {
    const double turns = std::floor(step / period);
    return {static_cast<std::int32_t>(step - turns * period), turns};
  }
  // Never on the end itself, where it would coincide with its mirror image.
  return {static_cast<std::int32_t>(std::clamp(step, 1.0, period - 1)), 0};
}

void RegionAxis::copies_of(std::int32_t at, std::vector<Copy>& copies) const {
  copies.clear();
  copies.push_back({at, 0, false});
  const std::int64_t period = periodic ? steps : 2 * steps;
  const auto add = [&](std::int64_t start, bool mirrored) {
    const std::int64_t before = (start + margin) / period;
    const std::int64_t after = (steps + margin - start) / period;
    for (std::int64_t n = -before; n <= after; ++n) {
      if (n == 0 && !mirrored) continue;
      const std::int64_t place = start + n * period;
      if (place < -margin || place > steps + margin) continue;
      copies.push_back({static_cast<std::int32_t>(place), static_cast<double>(n), !periodic});
    }
  };
  add(at, false);
  if (!periodic) add(-std::int64_t{at}, true);
}

Region region_of(const System& system, const Frame& frame) {
  const Box& box = system.box;
  Region region{axis_of(frame.x, box.size.x, box.boundary[0]), axis_of(frame.y, box.size.y, box.boundary[1])};
  const double longer = std::max(region.x.width, region.y.width);
  const double margin = kOpenMargin * longer + system.largest_radius();
  if (box.boundary[0] == Boundary::open) widen(region.x, margin);
  if (box.boundary[1] == Boundary::open) widen(region.y, margin);
  return region;
}

void lay_grid(Region& region, double margin, std::size_t disks) {
  const double with_strips = (region.x.width + 2 * margin) * (region.y.width + 2 * margin);
  const double copies = with_strips / (region.x.width * region.y.width);
  const double count = static_cast<double>(disks);
  if (copies > kMostCopiesPerDisk && copies * count > kMostCopies) {
    throw Error("Voronoi cells need too many periodic copies of these disks: the box is too narrow for its length");
  }
  const double finest = kMostSteps / (std::max(region.x.width, region.y.width) + margin);
  for (RegionAxis* const axis : {&region.x, &region.y}) {
    axis->steps = static_cast<std::int64_t>(std::floor(axis->width * finest));
    axis->margin = static_cast<std::int64_t>(std::floor(margin * finest));
    if (axis->steps < 2) throw Error("Voronoi cells: the box is too narrow for its length");
  }
}

}  // namespace carom
