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

/// The largest whole number not above x. (Compiled for any processor, std::floor is a call.)
inline double whole_part(double x) noexcept {
  if (!(std::abs(x) < 0x1p52)) return x;
  const auto cut = static_cast<double>(static_cast<std::int64_t>(x));
  return cut > x ? cut - 1 : cut;
}

/// One axis cut into `count` cells of equal width. Where the axis is not periodic the cells repeat beyond it all the
/// same: points from elsewhere that fall into a cell must be told apart by their distance.
struct GridAxis {
  double inverse_width = 1;
  double low = 0;
  double count = 1;
  bool periodic = false;

  /// Number of the cell that x lies in, over the whole axis.
  [[nodiscard]] double cell_of(double x) const noexcept { return whole_part((x - low) * inverse_width); }
  /// How many times `count` cells lie between that cell and its place among the first ones.
  [[nodiscard]] double turn_of(double cell) const noexcept {
    return cell >= 0 && cell < count ? 0 : whole_part(cell / count);
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
    if (columns.inside && rows.inside) {
      visit_inside(columns, rows, centre, following, point_of, visit);
    } else {
      visit_anywhere(columns, rows, following, point_of, visit);
    }
  }

 private:
  struct Range {
    double first = 0;
    int count = 0;
    bool inside = false;  // all cells are among the first ones
  };
  [[nodiscard]] static Range range(const GridAxis& axis, double centre, double reach) noexcept {
    const double first = axis.cell_of(centre - reach);
    double count = axis.cell_of(centre + reach) - first + 1;
    if (!axis.periodic) count = std::min(count, axis.count);
    return {first, static_cast<int>(count), first >= 0 && first + count <= axis.count};
  }

  template <class PointOf, class Visit>
  void visit_inside(const Range& columns, const Range& rows, Vec2 centre, const Array<Index>& following,
                    PointOf point_of, Visit visit) const {
    const Index* row =
        first_.data() + static_cast<std::size_t>(rows.first) * columns_ + static_cast<std::size_t>(columns.first);
    for (int b = 0; b < rows.count; ++b, row += columns_) {
      for (int a = 0; a < columns.count; ++a) {
        for (Index k = row[a]; k >= 0; k = following[k]) {
          const Vec2 point = point_of(k);
          // A point in these cells is near, or it lies beyond a seam and a copy of it is.
          if (std::abs(point.x - centre.x) < far_.x && std::abs(point.y - centre.y) < far_.y) {
            visit(k, Image{});
          } else {
            visit(k, Image{image(axis_[0], 0, point.x), image(axis_[1], 0, point.y)});
          }
        }
      }
    }
  }

  template <class PointOf, class Visit>
  void visit_anywhere(const Range& columns, const Range& rows, const Array<Index>& following, PointOf point_of,
                      Visit visit) const {
    for (int b = 0; b < rows.count; ++b) {
      const double row = rows.first + b;
      const double turn_y = axis_[1].turn_of(row);
      const std::size_t row_start = static_cast<std::size_t>(axis_[1].place_of(row, turn_y)) * columns_;
      for (int a = 0; a < columns.count; ++a) {
        const double column = columns.first + a;
        const double turn_x = axis_[0].turn_of(column);
        const auto place = static_cast<std::size_t>(axis_[0].place_of(column, turn_x));
        for (Index k = first_[row_start + place]; k >= 0; k = following[k]) {
          const Vec2 point = point_of(k);
          visit(k, Image{image(axis_[0], turn_x, point.x), image(axis_[1], turn_y, point.y)});
        }
      }
    }
  }

  [[nodiscard]] static std::int32_t image(const GridAxis& axis, double turn, double coordinate) noexcept {
    if (!axis.periodic) return 0;
    const double cell = (coordinate - axis.low) * axis.inverse_width;
    if (turn == 0 && cell >= 0 && cell < axis.count) return 0;
    return static_cast<std::int32_t>(turn - axis.turn_of(axis.cell_of(coordinate)));
  }
  [[nodiscard]] std::size_t place_of(Vec2 point) const noexcept {
    const double column = axis_[0].cell_of(point.x);
    const double row = axis_[1].cell_of(point.y);
    return static_cast<std::size_t>(axis_[1].place_of(row, axis_[1].turn_of(row))) * columns_ +
           static_cast<std::size_t>(axis_[0].place_of(column, axis_[0].turn_of(column)));
  }

  std::array<GridAxis, 2> axis_;
  std::size_t columns_ = 1;
  Vec2 far_;            // half the box: a point farther than that has a copy that is nearer
  Array<Index> first_;  // point of each cell; the others follow it
};

}  // namespace carom::fast
