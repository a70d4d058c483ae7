// Finds overlapping disks of any mix of sizes: grids in which each disk stands once, in the cell of its centre; disks
// of like size share a grid.
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
  /// The radii that come, positive.
  struct Radii {
    double smallest = 0;
    double largest = 0;
  };

  /// `extent` covers all centres; along periodic axes it is the box.
  OverlapGrid(const Box& box, Extent extent, Radii radii, std::size_t expected_disks);

  /// `id` below 2³² − 1.
  void insert(std::size_t id, Vec2 position, double radius);

  /// Calls visit(id, r) for each inserted disk, at each of its periodic copies, that may overlap a disk of this radius
  /// here; r from here to there.
  template <class Visit>
  void visit_near(Vec2 position, double radius, Visit visit) const {
    for (const Level& level : levels_) {
      if (level.empty) continue;
      const double reach = radius + level.largest;
      level.for_each_copy(position, reach, [&](Vec2 copy) {
        level.for_each_cell(copy, reach, [&](std::size_t cell) {
          for (std::uint32_t place = level.first[cell]; place != kNone; place = disks_[place].next) {
            visit(std::size_t{disks_[place].id}, disks_[place].position - copy);
          }
        });
      });
    }
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  struct Disk {
    Vec2 position;
    std::uint32_t id = 0;
    std::uint32_t next = kNone;  // place in disks_ of the next one in the same cell
  };

  struct Axis {
    double low = 0;
    double period = 0;  // 0 where the axis is not periodic
    double cells_per_length = 0;
    std::size_t cells = 1;

    [[nodiscard]] std::size_t cell_of(double coordinate) const noexcept;
    [[nodiscard]] int first_copy(double coordinate, double reach) const noexcept;
    [[nodiscard]] int last_copy(double coordinate, double reach) const noexcept;
  };

  /// Disks of radii within a factor of two.
  struct Level {
    double largest = 0;  // radius
    Axis x, y;
    std::vector<std::uint32_t> first;  // in each cell: a place in disks_
    bool empty = true;

    template <class Visit>
    void for_each_copy(Vec2 position, double reach, Visit visit) const {
      for (int nx = x.first_copy(position.x, reach); nx <= x.last_copy(position.x, reach); ++nx) {
        for (int ny = y.first_copy(position.y, reach); ny <= y.last_copy(position.y, reach); ++ny) {
          visit(Vec2{position.x + nx * x.period, position.y + ny * y.period});
        }
      }
    }

    template <class Visit>
    void for_each_cell(Vec2 centre, double reach, Visit visit) const {
      const std::size_t right = x.cell_of(centre.x + reach);
      const std::size_t top = y.cell_of(centre.y + reach);
      for (std::size_t row = y.cell_of(centre.y - reach); row <= top; ++row) {
        for (std::size_t column = x.cell_of(centre.x - reach); column <= right; ++column) {
          visit(row * x.cells + column);
        }
      }
    }
  };

  static Axis make_axis(double low, double high, bool periodic, double cell, double most_cells) noexcept;
  static Level make_level(const Box& box, Extent extent, Radii radii, std::size_t expected_disks);
  [[nodiscard]] std::size_t level_of(double radius) const noexcept;

  double smallest_ = 0;
  std::vector<Level> levels_;
  std::vector<Disk> disks_;
};

}  // namespace carom
