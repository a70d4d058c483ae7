// Finds overlapping disks of any mix of sizes: a grid in which each disk is entered in all cells that it touches.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/base/vec2.hpp"
#include "carom/state/system.hpp"

namespace carom {

class OverlapGrid {
 public:
  struct Extent {
    Vec2 low;
    Vec2 high;
  };

  /// `extent` covers all centres; along periodic axes it is the box. Cells are about `cell` wide.
  OverlapGrid(const Box& box, Extent extent, double cell, std::size_t expected_disks);

  void insert(std::size_t id, Vec2 position, double radius);

  /// Calls visit(id, r) for disks entered near enough to overlap the given one, r from it to the entered disk or its
  /// copy. A pair can be visited more than once, and disks that do not overlap are visited too.
  template <class Visit>
  void visit_near(Vec2 position, double radius, Visit visit) const {
    for_each_copy(position, radius, [&](Vec2 copy) {
      for_each_cell(copy, radius, [&](std::size_t cell) {
        for (const Entry& entry : cells_[cell]) visit(entry.id, entry.position - copy);
      });
    });
  }

 private:
  struct Entry {
    std::size_t id;
    Vec2 position;
  };

  struct Axis {
    double low = 0;
    double period = 0;  // 0 where the axis is not periodic
    double cells_per_length = 0;
    std::size_t cells = 1;

    [[nodiscard]] std::size_t cell_of(double coordinate) const noexcept;
    [[nodiscard]] int first_copy(double coordinate, double radius) const noexcept;
    [[nodiscard]] int last_copy(double coordinate, double radius) const noexcept;
  };

  static Axis make_axis(double low, double high, bool periodic, double cell, double most_cells) noexcept;

  template <class Visit>
  void for_each_copy(Vec2 position, double radius, Visit visit) const {
    for (int nx = x_.first_copy(position.x, radius); nx <= x_.last_copy(position.x, radius); ++nx) {
      for (int ny = y_.first_copy(position.y, radius); ny <= y_.last_copy(position.y, radius); ++ny) {
        visit(Vec2{position.x + nx * x_.period, position.y + ny * y_.period});
      }
    }
  }

  template <class Visit>
  void for_each_cell(Vec2 centre, double radius, Visit visit) const {
    const std::size_t right = x_.cell_of(centre.x + radius);
    const std::size_t top = y_.cell_of(centre.y + radius);
    for (std::size_t row = y_.cell_of(centre.y - radius); row <= top; ++row) {
      for (std::size_t column = x_.cell_of(centre.x - radius); column <= right; ++column) {
        visit(row * x_.cells + column);
      }
    }
  }

  Axis x_, y_;
  std::vector<std::vector<Entry>> cells_;
};

}  // namespace carom
