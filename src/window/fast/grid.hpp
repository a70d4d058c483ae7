// A grid that finds points near a point, periodic or not.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "carom/state/system.hpp"
#include "huge_pages.hpp"
#include "record.hpp"

namespace carom::fast {

/// A rectangle of the plane: all that there is, or a part cut out of it.
struct Extent {
  Vec2 low;
  Vec2 high;
  /// Along which axes it is a part only, of less than three quarters of a periodic box: it does not close on itself.
  std::array<bool, 2> cut{false, false};
};

/// The largest whole number not above x. (Compiled for any processor, std::floor is a call.)
inline double whole_part(double x) noexcept {
  if (!(std::abs(x) < 0x1p52)) return x;
  const auto cut = static_cast<double>(static_cast<std::int64_t>(x));
  return cut > x ? cut - 1 : cut;
}

/// How many periods a coordinate lies away from a part of a periodic axis around `middle`.
inline double periods_from(double coordinate, double middle, double period) noexcept {
  const double away = coordinate - middle;
  return std::abs(away) <= period / 2 ? 0 : whole_part(away / period + 0.5);
}

/// One axis cut into `count` cells of equal width. Where the axis is not periodic the cells repeat beyond it all the
/// same: points from elsewhere that fall into a cell must be told apart by their distance.
struct GridAxis {
  double inverse_width = 1;
  double low = 0;
  double count = 1;
  bool periodic = false;  // the cells go once around
  double period = 0;      // of an axis that is periodic but of which only a part is covered; else 0
  double middle = 0;      // of that part

  /// How many periods lie between a coordinate and where it is looked for.
  [[nodiscard]] double turn_of(double x) const noexcept {
    if (period > 0) return periods_from(x, middle, period);
    if (!periodic) return 0;
    const double cell = (x - low) * inverse_width;
    return cell >= 0 && cell < count ? 0 : turn_of_cell(whole_part(cell));
  }
  /// Number of the cell that x lies in, over the whole axis, or from the part that is covered.
  [[nodiscard]] double cell_of(double x) const noexcept {
    const double place = period > 0 ? x - period * turn_of(x) : x;
    return whole_part((place - low) * inverse_width);
  }
  /// How many times `count` cells lie between a cell and its place among the first ones.
  [[nodiscard]] double turn_of_cell(double cell) const noexcept {
    return cell >= 0 && cell < count ? 0 : whole_part(cell / count);
  }
  [[nodiscard]] std::int32_t place_of(double cell) const noexcept {
    return static_cast<std::int32_t>(std::clamp(cell - count * turn_of_cell(cell), 0.0, count - 1));
  }
};

/// Points by the cell they lie in. Each point is one of a numbered set; its coordinates are the caller's and must be
/// the same when it is inserted, visited and removed.
class Grid {
 public:
  /// Cells of at least `width`, about one per point, for points within `extent` (which counts only along axes that
  /// are not periodic: points may lie outside, at a price).
  Grid(const Box& box, const Extent& extent, double width, std::size_t points);

  void insert(Index k, Vec2 point);
  void remove(Index k, Vec2 point);

  static constexpr int kSlots = 5;  ///< per cell; the last one is taken last
  /// Slots of neighbouring cells: `rows` rows of `slots` slots, one row `stride` after the other. Behind a row 16 more
  /// can be read.
  struct Rows {
    static constexpr int kMost = 120;  ///< slots in all
    const Index* first = nullptr;
    std::size_t stride = 0;
    int slots = 0;
    int rows = 0;
  };

  /// The cells within `reach` of `centre`; none where there is more to tell: copies, too many cells.
  [[nodiscard]] Rows rows_near(Vec2 centre, double reach) const noexcept {
    const Range columns = range(axis_[0], centre.x, reach);
    const Range rows = range(axis_[1], centre.y, reach);
    const int slots = columns.count * kSlots;
    if (!columns.inside || !rows.inside || slots * rows.count > Rows::kMost) return {};
    const std::size_t first = static_cast<std::size_t>(rows.first) * columns_ + static_cast<std::size_t>(columns.first);
    return {slots_.data() + first * kSlots, columns_ * kSlots, slots, rows.count};
  }
  /// Whether both lie in the same cell.
  [[nodiscard]] bool in_same_cell(Vec2 a, Vec2 b) const noexcept { return place_of(a) == place_of(b); }
  /// Half the box: a point farther than that has a copy that is nearer (length).
  [[nodiscard]] Vec2 far() const noexcept { return far_; }

  /// Calls visit(k, image) for every point whose copy at point + image L lies within `reach` of `centre` along both
  /// axes, and for some that lie farther. `point_of(k)` gives a point.
  template <class PointOf, class Visit>
  void visit_near(Vec2 centre, double reach, PointOf point_of, Visit visit) const {
    const Range columns = range(axis_[0], centre.x, reach);
    const Range rows = range(axis_[1], centre.y, reach);
    for (int b = 0; b < rows.count; ++b) {
      const double row = rows.first + b;
      const double turn_y = axis_[1].periodic ? axis_[1].turn_of_cell(row) : rows.turn;
      const std::size_t row_start = static_cast<std::size_t>(axis_[1].place_of(row)) * columns_;
      for (int a = 0; a < columns.count; ++a) {
        const double column = columns.first + a;
        const double turn_x = axis_[0].periodic ? axis_[0].turn_of_cell(column) : columns.turn;
        for_points_in(row_start + static_cast<std::size_t>(axis_[0].place_of(column)), [&](Index k) {
          const Vec2 point = point_of(k);
          visit(k, Image{static_cast<std::int32_t>(turn_x - axis_[0].turn_of(point.x)),
                         static_cast<std::int32_t>(turn_y - axis_[1].turn_of(point.y))});
        });
      }
    }
  }

 private:
  struct Range {
    double first = 0;
    int count = 0;
    double turn = 0;      // of the centre, where a part of a periodic axis is covered
    bool inside = false;  // all cells are among the first ones
  };
  [[nodiscard]] static Range range(const GridAxis& axis, double centre, double reach) noexcept {
    Range range;
    if (axis.period > 0) {
      range.turn = axis.turn_of(centre);
      centre -= axis.period * range.turn;
    }
    const auto cell_at = [&](double x) { return whole_part((x - axis.low) * axis.inverse_width); };
    range.first = cell_at(centre - reach);
    double count = cell_at(centre + reach) - range.first + 1;
    if (!axis.periodic) count = std::min(count, axis.count);
    range.count = static_cast<int>(count);
    range.inside = range.first >= 0 && range.first + count <= axis.count;
    return range;
  }

  template <class Visit>
  void for_points_in(std::size_t cell, Visit visit) const {
    const Index* const slots = slots_.data() + cell * kSlots;
    for (int m = 0; m < kSlots && slots[m] >= 0; ++m) visit(slots[m]);
    if (slots[kSlots - 1] < 0 || surplus_.empty()) return;
    const auto found = surplus_.find(cell);
    if (found == surplus_.end()) return;
    for (const Index k : found->second) visit(k);
  }

  [[nodiscard]] std::size_t place_of(Vec2 point) const noexcept {
    return static_cast<std::size_t>(axis_[1].place_of(axis_[1].cell_of(point.y))) * columns_ +
           static_cast<std::size_t>(axis_[0].place_of(axis_[0].cell_of(point.x)));
  }

  std::array<GridAxis, 2> axis_;
  std::size_t columns_ = 1;
  Vec2 far_;
  Array<Index> slots_;  // kSlots of each cell, the taken ones first; -1 where there is no point; then room to read
  std::unordered_map<std::size_t, std::vector<Index>> surplus_;  // points that found no slot in their cell
};

}  // namespace carom::fast
