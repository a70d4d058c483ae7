#include "grid.hpp"

namespace carom::fast {

Grid::Grid(const Box& box, const Extent& extent, double width, std::size_t points) {
  const std::array wraps{box.periodic(0) && !extent.cut[0], box.periodic(1) && !extent.cut[1]};
  const Vec2 size{wraps[0] ? box.size.x : extent.high.x - extent.low.x,
                  wraps[1] ? box.size.y : extent.high.y - extent.low.y};
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
    GridAxis& along = axis_[axis];
    along.inverse_width = wraps[axis] ? count / length : inverse;
    along.low = wraps[axis] ? 0 : low;
    along.count = count;
    along.periodic = wraps[axis];
    if (box.periodic(axis) && extent.cut[axis]) {
      along.period = axis == 0 ? box.size.x : box.size.y;
      along.middle = low + length / 2;
    }
  }
  columns_ = static_cast<std::size_t>(columns);
  far_ = {box.periodic(0) ? box.size.x / 2 : predict::kNever, box.periodic(1) ? box.size.y / 2 : predict::kNever};
  slots_.assign(columns_ * static_cast<std::size_t>(rows) * kSlots + 16, -1);
}

void Grid::insert(Index k, Vec2 point) {
  const std::size_t cell = place_of(point);
  Index* const slots = slots_.data() + cell * kSlots;
  for (int m = 0; m < kSlots; ++m) {
    if (slots[m] >= 0) continue;
    slots[m] = k;
    return;
  }
  surplus_[cell].push_back(k);
}

void Grid::remove(Index k, Vec2 point) {
  const std::size_t cell = place_of(point);
  Index* const slots = slots_.data() + cell * kSlots;
  const auto surplus = slots[kSlots - 1] < 0 ? surplus_.end() : surplus_.find(cell);
  Index* const here = std::find(slots, slots + kSlots, k);
  if (surplus != surplus_.end()) {
    // The last one of the surplus takes the place that becomes free.
    std::vector<Index>& others = surplus->second;
    (here < slots + kSlots ? *here : *std::find(others.begin(), others.end(), k)) = others.back();
    others.pop_back();
    if (others.empty()) surplus_.erase(surplus);
    return;
  }
  Index* const end = std::find(slots, slots + kSlots, -1);
  *here = *(end - 1);
  *(end - 1) = -1;
}

}  // namespace carom::fast
