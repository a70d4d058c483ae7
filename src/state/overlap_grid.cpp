#include "overlap_grid.hpp"

#include <algorithm>

namespace carom {
namespace {

constexpr std::size_t kMostLevels = 24;

/// How often `radius` is twice `smallest`, rounded down.
std::size_t doublings(double radius, double smallest) noexcept {
  int exponent = 0;
  std::frexp(radius / smallest, &exponent);
  return std::min(static_cast<std::size_t>(std::max(exponent - 1, 0)), kMostLevels - 1);
}

}  // namespace

OverlapGrid::Axis OverlapGrid::make_axis(double low, double high, bool periodic, double cell,
                                         double most_cells) noexcept {
  const double width = high - low;
  const double wanted = cell > 0 && width > 0 ? std::floor(width / cell) : 1;
  const double cells = std::clamp(wanted, 1.0, most_cells);
  return {low, periodic ? width : 0, width > 0 ? cells / width : 0, static_cast<std::size_t>(cells)};
}

OverlapGrid::Level OverlapGrid::make_level(const Box& box, Extent extent, Radii radii, std::size_t expected_disks) {
  // At most some four cells a disk in all, shared between the axes by their lengths.
  const Vec2 size = extent.high - extent.low;
  const double budget = 4 * static_cast<double>(expected_disks) + 16;
  const double area = size.x * size.y;
  const double finest = area > 0 ? std::sqrt(area / budget) : std::max(size.x, size.y) / budget;
  const double width = std::max(2 * radii.smallest, finest);
  Level level;
  level.largest = radii.largest;
  level.x = make_axis(extent.low.x, extent.high.x, box.periodic(0), width, budget);
  level.y = make_axis(extent.low.y, extent.high.y, box.periodic(1), width, budget);
  level.first.assign(level.x.cells * level.y.cells, kNone);
  return level;
}

OverlapGrid::OverlapGrid(const Box& box, Extent extent, Radii radii, std::size_t expected_disks)
    : smallest_(radii.smallest) {
  const std::size_t last = doublings(radii.largest, smallest_);
  for (std::size_t number = 0; number <= last; ++number) {
    const double from = std::ldexp(smallest_, static_cast<int>(number));
    const Radii here{from, number == last ? radii.largest : 2 * from};
    levels_.push_back(make_level(box, extent, here, expected_disks));
  }
  disks_.reserve(expected_disks);
}

std::size_t OverlapGrid::level_of(double radius) const noexcept {
  return std::min(doublings(radius, smallest_), levels_.size() - 1);
}

std::size_t OverlapGrid::Axis::cell_of(double coordinate) const noexcept {
  const double cell = std::floor((coordinate - low) * cells_per_length);
  return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(cells - 1)));
}

// Copies coordinate + n period from which [low, low + period] is in reach.
int OverlapGrid::Axis::first_copy(double coordinate, double reach) const noexcept {
  return period > 0 ? static_cast<int>(std::ceil((low - reach - coordinate) / period)) : 0;
}
int OverlapGrid::Axis::last_copy(double coordinate, double reach) const noexcept {
  return period > 0 ? static_cast<int>(std::floor((low + period + reach - coordinate) / period)) : 0;
}

void OverlapGrid::insert(std::size_t id, Vec2 position, double radius) {
  Level& level = levels_[level_of(radius)];
  std::uint32_t& first = level.first[level.y.cell_of(position.y) * level.x.cells + level.x.cell_of(position.x)];
  disks_.push_back({position, static_cast<std::uint32_t>(id), first});
  first = static_cast<std::uint32_t>(disks_.size() - 1);
  level.empty = false;
}

}  // namespace carom
