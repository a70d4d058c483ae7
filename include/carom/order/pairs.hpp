// Pairs of disks near one another, with all periodic images, in a time proportional to their number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "carom/base/vec2.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// Throws Error unless `range` (length) is positive and finite, and no more than 20 times a periodic side: farther than
/// that there is nothing but images. `what` names the range in the message.
void check_pair_range(std::string_view what, const Box& box, double range);

/// The disks of one frame sorted into cells, for pairs up to one distance. A copy: the frame may go.
class PairGrid {
 public:
  /// `range` (length) is the largest distance of centres; it may reach beyond a periodic box. Throws Error where
  /// check_pair_range() does.
  PairGrid(const Box& box, const Frame& frame, double range);

  /// Calls visit(i, j, r) once for every two disks and image with |r| ≤ range, r from disk i to disk j or its periodic
  /// image. A disk and its own image are a pair too (i = j). The order of calls, and which of the two comes first,
  /// depends on the frame alone.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::int64_t row = 0; row < y_.cells; ++row) {
      for (std::int64_t column = 0; column < x_.cells; ++column) visit_cell(column, row, visit);
    }
  }

 private:
  /// Cells along one axis. A cell beyond the last belongs to a periodic image, or does not exist.
  struct Axis {
    double low = 0;
    double width = 0;
    bool periodic = false;
    std::int64_t cells = 1;
    std::int64_t reach = 0;  ///< how many cells away a partner can be

    [[nodiscard]] std::int64_t cell_of(double coordinate) const noexcept;
  };

  /// A run of sorted disks in one cell, and what to add to their positions.
  struct Cell {
    std::size_t first = 0;
    std::size_t last = 0;
    Vec2 shift;
  };

  static Axis make_axis(const std::vector<double>& coordinates, double size, Boundary boundary);
  static void divide(Axis& axis, double range, double finest) noexcept;
  void sort_into_cells(const Frame& frame);

  /// The cell at any column and row, images included; an empty one where there is none.
  [[nodiscard]] Cell cell(std::int64_t column, std::int64_t row) const noexcept {
    std::int64_t turns_x = 0;
    std::int64_t turns_y = 0;
    if (!fold(x_, column, turns_x) || !fold(y_, row, turns_y)) return {};
    const auto index = static_cast<std::size_t>(row * x_.cells + column);
    return {first_[index],
            first_[index + 1],
            {static_cast<double>(turns_x) * x_.width, static_cast<double>(turns_y) * y_.width}};
  }

  static bool fold(const Axis& axis, std::int64_t& index, std::int64_t& turns) noexcept {
    if (index >= 0 && index < axis.cells) return true;
    if (!axis.periodic) return false;
    turns = index >= 0 ? index / axis.cells : -((axis.cells - 1 - index) / axis.cells);
    index -= turns * axis.cells;
    return true;
  }

  /// Pairs within the cell, and with those cells that come after it: further right in its row, or in a later row.
  template <class Visit>
  void visit_cell(std::int64_t column, std::int64_t row, Visit& visit) const {
    const Cell here = cell(column, row);
    if (here.first == here.last) return;
    for (std::size_t a = here.first; a < here.last; ++a) visit_disk(a, {a + 1, here.last, {}}, visit);
    for (std::int64_t dx = 1; dx <= x_.reach; ++dx) visit_cells(here, cell(column + dx, row), visit);
    for (std::int64_t dy = 1; dy <= y_.reach; ++dy) {
      for (std::int64_t dx = -x_.reach; dx <= x_.reach; ++dx) visit_cells(here, cell(column + dx, row + dy), visit);
    }
  }

  template <class Visit>
  void visit_cells(const Cell& here, const Cell& there, Visit& visit) const {
    if (there.first == there.last) return;
    for (std::size_t a = here.first; a < here.last; ++a) visit_disk(a, there, visit);
  }

  template <class Visit>
  void visit_disk(std::size_t a, const Cell& partners, Visit& visit) const {
    const Vec2 from = position_[a] - partners.shift;
    for (std::size_t b = partners.first; b < partners.last; ++b) {
      const Vec2 r = position_[b] - from;
      if (dot(r, r) <= range_squared_) visit(std::size_t{id_[a]}, std::size_t{id_[b]}, r);
    }
  }

  double range_squared_;
  Axis x_, y_;
  std::vector<std::size_t> first_;  // of each cell's disks in the arrays below; one more at the end
  std::vector<Vec2> position_;      // by cell, in it by id; folded into the box along periodic axes
  std::vector<std::uint32_t> id_;
};

}  // namespace carom
