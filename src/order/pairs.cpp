#include "carom/order/pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "carom/base/error.hpp"

namespace carom {
namespace {

// A third of the range: the cells that are searched then cover little more than the circle.
constexpr double kCellsPerRange = 3;
constexpr double kMostSides = 20;

}  // namespace

void check_pair_range(std::string_view what, const Box& box, double range) {
  if (!(range > 0) || !std::isfinite(range * range)) {
    throw Error(fmt::format("{} is {}: it must be positive and finite", what, range));
  }
  for (const int axis : {0, 1}) {
    const double side = axis == 0 ? box.size.x : box.size.y;
    if (box.periodic(axis) && range > kMostSides * side) {
      throw Error(fmt::format("{} is {}: that is more than {} times the periodic box's side of {}", what, range,
                              kMostSides, side));
    }
  }
}

std::int64_t PairGrid::Axis::cell_of(double coordinate) const noexcept {
  if (!(width > 0)) return 0;
  const double cell = std::floor((coordinate - low) / width * static_cast<double>(cells));
  return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(cells - 1)));
}

PairGrid::Axis PairGrid::make_axis(const std::vector<double>& coordinates, double size, Boundary boundary) {
  Axis axis;
  axis.periodic = boundary == Boundary::periodic;
  axis.width = size;
  if (!axis.periodic && !coordinates.empty()) {
    const auto [low, high] = std::minmax_element(coordinates.begin(), coordinates.end());
    axis.low = *low;
    axis.width = *high - *low;
  }
  return axis;
}

void PairGrid::divide(Axis& axis, double range, double finest) noexcept {
  if (!(axis.width > 0)) return;
  const double wanted = std::floor(axis.width / std::max(range / kCellsPerRange, finest));
  axis.cells = static_cast<std::int64_t>(std::max(wanted, 1.0));
  // Rounding can put a disk into the cell next to its own; a little more range finds it there too.
  const double reach = std::ceil(range * (1 + 1e-9) / axis.width * static_cast<double>(axis.cells));
  axis.reach = static_cast<std::int64_t>(axis.periodic ? reach : std::min(reach, static_cast<double>(axis.cells - 1)));
}

PairGrid::PairGrid(const Box& box, const Frame& frame, double range)
    : range_squared_(range * range),
      x_(make_axis(frame.x, box.size.x, box.boundary[0])),
      y_(make_axis(frame.y, box.size.y, box.boundary[1])) {
  check_pair_range("the range of pairs", box, range);
  // At least as coarse as makes one cell a disk.
  const double count = static_cast<double>(std::max<std::size_t>(frame.size(), 1));
  const double finest = std::max(std::sqrt(x_.width * y_.width / count), std::max(x_.width, y_.width) / count);
  divide(x_, range, finest);
  divide(y_, range, finest);
  sort_into_cells(frame);
}

void PairGrid::sort_into_cells(const Frame& frame) {
  const std::size_t count = frame.size();
  std::vector<Vec2> folded(count);
  std::vector<std::size_t> cell_of(count);
  first_.assign(static_cast<std::size_t>(x_.cells * y_.cells) + 1, 0);
  for (std::size_t k = 0; k < count; ++k) {
    folded[k] = {x_.periodic ? wrap(frame.x[k], x_.width).coordinate : frame.x[k],
                 y_.periodic ? wrap(frame.y[k], y_.width).coordinate : frame.y[k]};
    cell_of[k] = static_cast<std::size_t>(y_.cell_of(folded[k].y) * x_.cells + x_.cell_of(folded[k].x));
    ++first_[cell_of[k] + 1];
  }
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  position_.resize(count);
  id_.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t place = next[cell_of[k]]++;
    position_[place] = folded[k];
    id_[place] = static_cast<std::uint32_t>(k);
  }
}

}  // namespace carom
