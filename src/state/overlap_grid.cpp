#include "overlap_grid.hpp"

#include <algorithm>

namespace carom {

OverlapGrid::Axis OverlapGrid::make_axis(double low, double high, bool periodic, double cell,
                                         double most_cells) noexcept {
  const double width = high - low;
  const double wanted = cell > 0 && width > 0 ? std::floor(width / cell) : 1;
  const double cells = std::clamp(wanted, 1.0, most_cells);
  return {low, periodic ? width : 0, width > 0 ? cells / width : 0, static_cast<std::size_t>(cells)};
}

OverlapGrid::OverlapGrid(const Box& box, Extent extent, double cell, std::size_t expected_disks) {
  // At most some four cells a disk in all, shared between the axes by their lengths.
  const Vec2 size = extent.high - extent.low;
  const double budget = 4 * static_cast<double>(expected_disks) + 16;
  const double area = size.x * size.y;
  const double finest = area > 0 ? std::sqrt(area / budget) : std::max(size.x, size.y) / budget;
  const double width = std::max(cell, finest);
  x_ = make_axis(extent.low.x, extent.high.x, box.periodic(0), width, budget);
  y_ = make_axis(extent.low.y, extent.high.y, box.periodic(1), width, budget);
  cells_.resize(x_.cells * y_.cells);
}

std::size_t OverlapGrid::Axis::cell_of(double coordinate) const noexcept {
  const double cell = std::floor((coordinate - low) * cells_per_length);
  return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(cells - 1)));
}

// Copies coordinate + n period that reach into [low, low + period].
int OverlapGrid::Axis::first_copy(double coordinate, double radius) const noexcept {
  return period > 0 ? static_cast<int>(std::ceil((low - radius - coordinate) / period)) : 0;
}
int OverlapGrid::Axis::last_copy(double coordinate, double radius) const noexcept {
  return period > 0 ? static_cast<int>(std::floor((low + period + radius - coordinate) / period)) : 0;
}

void OverlapGrid::insert(std::size_t id, Vec2 position, double radius) {
  for_each_copy(position, radius, [&](Vec2 copy) {
    for_each_cell(copy, radius, [&](std::size_t cell) { cells_[cell].push_back({id, copy}); });
  });
}

}  // namespace carom
