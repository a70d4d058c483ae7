#include "grid.hpp"

namespace carom::fast {

Grid::Grid(const Box& box, const Extent& extent, double width, std::size_t points) {
  const Vec2 size{box.periodic(0) ? box.size.x : extent.high.x - extent.low.x,
                  box.periodic(1) ? box.size.y : extent.high.y - extent.low.y};
  const double most = static_cast<double>(points) + 16;
  const auto cells_along = [&](double length) { return std::clamp(std::floor(length / width), 1.0, most); };
  double columns = cells_along(size.x);
  double rows = cells_along(size.y);
  // No more cells than points: along both axes fewer, along a narrow box's length alone.
  while (columns * rows > most) (columns > rows ? columns : rows) = std::ceil(std::max(columns, rows) / 2);
  for (int axis = 0; axis < 2; ++axis) {
    const double length = axis == 0 ? size.x : size.y;
    const double count = axis == 0 ? columns : rows;
    const double low = axis == 0 ? extent.low.x : extent.low.y;
    // A cell wider than asked for where there is but one.
    const double inverse = length > width ? count / length : 1 / width;
    axis_[axis] = {box.periodic(axis) ? count / length : inverse, box.periodic(axis) ? 0 : low, count,
                   box.periodic(axis)};
  }
  columns_ = static_cast<std::size_t>(columns);
  far_ = {box.periodic(0) ? size.x / 2 : predict::kNever, box.periodic(1) ? size.y / 2 : predict::kNever};
  first_.assign(columns_ * static_cast<std::size_t>(rows), -1);
}

}  // namespace carom::fast
