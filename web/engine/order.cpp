#include "order.hpp"

#include <algorithm>
#include <cmath>

namespace carom::page {
namespace {

/// Disks by cells of a grid at least `reach` wide, each cell's as a chain.
class Grid {
 public:
  Grid(const Box& box, const Frame& frame, double reach) : box_(box), frame_(frame) {
    for (int axis = 0; axis < 2; ++axis) {
      const double size = axis == 0 ? box.size.x : box.size.y;
      count_[axis] = std::clamp(static_cast<int>(size / reach), 1, 4096);
      width_[axis] = size / count_[axis];
    }
    first_.assign(static_cast<std::size_t>(count_[0]) * count_[1], -1);
    next_.assign(frame.size(), -1);
    for (std::size_t k = 0; k < frame.size(); ++k) {
      int& head = first_[cell(column(frame.x[k], 0), column(frame.y[k], 1))];
      next_[k] = head;
      head = static_cast<int>(k);
    }
  }

  /// Calls see(r) with the vector to every other disk in this cell or one beside it, at its nearest copy.
  template <class See>
  void for_around(std::size_t k, See&& see) const {
    const int column_x = column(frame_.x[k], 0);
    const int column_y = column(frame_.y[k], 1);
    for (int x = lowest(0); x <= highest(0); ++x) {
      for (int y = lowest(1); y <= highest(1); ++y) {
        const int cx = neighbour(column_x + x, 0);
        const int cy = neighbour(column_y + y, 1);
        if (cx < 0 || cy < 0) continue;
        for (int j = first_[cell(cx, cy)]; j >= 0; j = next_[j]) {
          if (static_cast<std::size_t>(j) != k) see(nearest(frame_.position(j) - frame_.position(k)));
        }
      }
    }
  }

 private:
  // With fewer than three cells around a seam, a cell must not be its own neighbour twice.
  [[nodiscard]] int lowest(int axis) const { return count_[axis] >= 2 ? -1 : 0; }
  [[nodiscard]] int highest(int axis) const { return count_[axis] >= 3 || !box_.periodic(axis) ? 1 : 0; }
  [[nodiscard]] std::size_t cell(int x, int y) const { return static_cast<std::size_t>(y) * count_[0] + x; }
  [[nodiscard]] int column(double x, int axis) const {
    return std::clamp(static_cast<int>(x / width_[axis]), 0, count_[axis] - 1);
  }
  [[nodiscard]] int neighbour(int column, int axis) const {
    if (column >= 0 && column < count_[axis]) return column;
    return box_.periodic(axis) ? (column + count_[axis]) % count_[axis] : -1;
  }
  [[nodiscard]] Vec2 nearest(Vec2 r) const {
    if (box_.periodic(0)) r.x -= box_.size.x * std::rint(r.x / box_.size.x);
    if (box_.periodic(1)) r.y -= box_.size.y * std::rint(r.y / box_.size.y);
    return r;
  }

  const Box& box_;
  const Frame& frame_;
  int count_[2];
  double width_[2];
  std::vector<int> first_;
  std::vector<int> next_;
};

}  // namespace

std::vector<std::complex<double>> hexatic_order(const System& system, const Frame& frame) {
  std::vector<std::complex<double>> order(frame.size());
  const double area = system.box.size.x * system.box.size.y;
  if (frame.size() < 2 || !(area > 0)) return order;
  const double reach = 1.5 * std::sqrt(2 / std::sqrt(3.0) * area / static_cast<double>(frame.size()));
  const Grid grid(system.box, frame, reach);
  for (std::size_t k = 0; k < frame.size(); ++k) {
    int neighbours = 0;
    grid.for_around(k, [&](Vec2 r) {
      const double r2 = dot(r, r);
      if (!(r2 < reach * reach) || r2 == 0) return;
      const std::complex<double> squared = std::complex<double>(r.x, r.y) * std::complex<double>(r.x, r.y) / r2;
      order[k] += squared * squared * squared;
      ++neighbours;
    });
    if (neighbours > 0) order[k] /= neighbours;
  }
  return order;
}

}  // namespace carom::page
