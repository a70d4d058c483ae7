// A grid that finds points near a point, periodic or not.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "carom/state/system.hpp"
#include "huge_pages.hpp"
#include "record.hpp"

namespace carom::fast {

/// A rectangle of the plane.
struct Extent {
  Vec2 low;
  Vec2 high;
};

/// One axis cut into `count` cells of equal width. Where the axis is not periodic the cells repeat beyond it all the
/// same: points from elsewhere that fall into a cell must be told apart by their distance.
struct GridAxis {
  double inverse_width = 1;
  double low = 0;
  double count = 1;
  bool periodic = false;

  /// Number of the cell that x lies in, over the whole axis.
  [[nodiscard]] double cell_of(double x) const noexcept { return std::floor((x - low) * inverse_width); }
  /// How many times `count` cells lie between that cell and its place among the first ones.
  [[nodiscard]] double turn_of(double cell) const noexcept {
    return cell >= 0 && cell < count ? 0 : std::floor(cell / count);
  }
  [[nodiscard]] std::int32_t place_of(double cell, double turn) const noexcept {
    return static_cast<std::int32_t>(std::clamp(cell - count * turn, 0.0, count - 1));
  }
};

/// Points by the cell they lie in. Each point is one of a numbered set; its coordinates are the caller's and must be
/// the same when it is inserted, visited and removed.
class Grid {
 public:
  /// Cells of at least `width`, about one per point, for points within `extent` (which counts only along axes that
  /// are not periodic: points may lie outside, at a price).
  Grid(const Box& box, const Extent& extent, double width, std::size_t points);

  void insert(Index k, Vec2 point, Array<Index>& following) noexcept {
    Index& first = first_[place_of(point)];
    following[k] = first;
    first = k;
  }
  void remove(Index k, Vec2 point, Array<Index>& following) noexcept {
    Index* link = &first_[place_of(point)];
    while (*link != k) link = &following[*link];
    *link = following[k];
  }

  /// Calls visit(k, image) for every point whose copy at point + image L lies within `reach` of `centre` along both
  /// axes, and for some that lie farther. `point_of(k)` gives a point.
  template <class PointOf, class Visit>
  void visit_near(Vec2 centre, double reach, const Array<Index>& following, PointOf point_of, Visit visit) const {
    const Range columns = range(axis_[0], centre.x, reach);
    const Range rows = range(axis_[1], centre.y, reach);
    for (int b = 0; b < rows.count; ++b) {
      const double row = rows.first + b;
      const double turn_y = axis_[1].turn_of(row);
      const std::size_t row_start = static_cast<std::size_t>(axis_[1].place_of(row, turn_y)) * columns_;
      for (int a = 0; a < columns.count; ++a) {
        const double column = columns.first + a;
        const double turn_x = axis_[0].turn_of(column);
        for (Index k = first_[row_start + axis_[0].place_of(column, turn_x)]; k >= 0; k = following[k]) {
          const Vec2 point = point_of(k);
          visit(k, Image{image(axis_[0], turn_x, point.x), image(axis_[1], turn_y, point.y)});
        }
      }
    }
  }

 private:
  struct Range {
    double first = 0;
    int count = 0;
  };
  [[nodiscard]] static Range range(const GridAxis& axis, double centre, double reach) noexcept {
    const double first = axis.cell_of(centre - reach);
    double count = axis.cell_of(centre + reach) - first + 1;
    if (!axis.periodic) count = std::min(count, axis.count);
    return {first, static_cast<int>(count)};
  }
  [[nodiscard]] static std::int32_t image(const GridAxis& axis, double turn, double coordinate) noexcept {
    return axis.periodic ? static_cast<std::int32_t>(turn - axis.turn_of(axis.cell_of(coordinate))) : 0;
  }
  [[nodiscard]] std::size_t place_of(Vec2 point) const noexcept {
    const double column = axis_[0].cell_of(point.x);
    const double row = axis_[1].cell_of(point.y);
    return static_cast<std::size_t>(axis_[1].place_of(row, axis_[1].turn_of(row))) * columns_ +
           static_cast<std::size_t>(axis_[0].place_of(column, axis_[0].turn_of(column)));
  }

  std::array<GridAxis, 2> axis_;
  std::size_t columns_ = 1;
  Array<Index> first_;  // point of each cell; the others follow it
};

}  // namespace carom::fast
