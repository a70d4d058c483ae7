// Neighbour lists: for every disk those that it can meet before it leaves the place where its list was made.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "carom/state/system.hpp"
#include "carom/window/collision.hpp"
#include "grid.hpp"
#include "huge_pages.hpp"
#include "neighbour.hpp"
#include "record.hpp"

namespace carom::fast {

/// The list of one disk: one cache line.
///
/// A list without traits holds all that its disk can meet: up to kRoom disks, none across a seam. The rest of `near`
/// repeats the disk itself, which never meets itself. With traits, Lists::neighbours has to be asked.
struct alignas(64) List {
  static constexpr std::uint16_t kRoom = 10;
  static constexpr std::uint16_t kReadable = 8;  ///< so many can be read where they are, in whole vectors
  static constexpr std::uint16_t kLong = 1;      ///< too many disks, or copies across a seam; near[0] tells where
  static constexpr std::uint16_t kNearWall = 2;  ///< a wall is within reach

  double x, y;  ///< centre: where the disk was when its list was made, in the frame of its stored position (length)
  std::uint16_t count;
  std::uint16_t traits;
  std::uint32_t partner_events;  ///< contacts of the record's partner when the record's event was predicted
  std::array<Index, kRoom> near;
};
static_assert(sizeof(List) == 64);

/// The hot steps of making plain lists, for one set of instructions.
struct ListSteps {
  static constexpr int kRoom = Grid::Rows::kMost + 16;

  /// Writes to `found` which disks in these slots, other than k, have their centres nearer to k's than the square root
  /// of `range_squared`; returns how many. Returns -1 if that may not be all: a cell is full, or a disk is so far
  /// that a copy may be nearer. All disks are in `lists`; `found` has room for kRoom.
  int (*find)(const Grid::Rows& rows, const List* lists, Index k, double range_squared, double far_squared,
              Index* found) = nullptr;
  /// Takes disk k out of the lists of these. Returns how many it did: it stops at one that is long.
  int (*drop)(List* lists, const Index* disks, int count, Index k) = nullptr;
};

/// Without vector instructions.
ListSteps scalar_list_steps() noexcept;

/// Lists reach to contact distance + shell; a disk that has gone half a shell from its list's centre needs a new one.
class Lists {
 public:
  /// Around where the disks are at `time`. `slack`: more than rounding can move a disk.
  Lists(const System& system, const Extent& extent, double shell, double slack, const Array<Record>& records,
        const Array<DiskId>& ids, const ListSteps& steps, double time = 0);

  [[nodiscard]] List& operator[](Index k) noexcept { return lists_[k]; }
  [[nodiscard]] const List& operator[](Index k) const noexcept { return lists_[k]; }
  /// How far a disk may go from its list's centre (length), and that squared.
  [[nodiscard]] double leash() const noexcept { return leash_; }
  [[nodiscard]] double shell() const noexcept { return shell_; }
  [[nodiscard]] double leash_squared() const noexcept { return leash_ * leash_; }
  /// Mean number of neighbours.
  [[nodiscard]] double mean_length() const noexcept;

  /// Calls visit(Neighbour) for every neighbour of disk k.
  template <class Visit>
  void for_neighbours(Index k, Visit visit) const {
    const List& list = lists_[k];
    if ((list.traits & List::kLong) != 0) {
      for (const Neighbour& neighbour : long_[list.near[0]].neighbours) visit(neighbour);
    } else {
      for (int m = 0; m < list.count; ++m) visit(Neighbour{list.near[m], {}});
    }
  }

  /// The image of the partner in the disk's next event.
  [[nodiscard]] Image partner_image(Index k) const noexcept {
    return (lists_[k].traits & List::kLong) != 0 ? long_[lists_[k].near[0]].partner_image : Image{};
  }
  void set_partner_image(Index k, Image image) noexcept { long_[lists_[k].near[0]].partner_image = image; }

  /// Makes a new list for disk k around `centre`, and enters k in the lists of those that it holds.
  void renew(Index k, Vec2 centre);

 private:
  struct Long {
    std::vector<Neighbour> neighbours;
    Image partner_image;
  };

  /// Disks of similar size share a grid.
  struct Level {
    double largest_radius = 0;
    Grid grid;
  };

  [[nodiscard]] Vec2 centre(Index k) const noexcept { return {lists_[k].x, lists_[k].y}; }
  [[nodiscard]] std::size_t level_of(double radius) const noexcept;
  void make_levels(const System& system, const Extent& extent);
  void look_around(Index k, bool both_ways);
  bool take_near(Index k, double reach, const Grid& grid, bool both_ways);
  [[nodiscard]] int find_of_any_size(const Grid::Rows& rows, Index k, double far_squared, Index* found) const;
  void drop_everywhere(Index k);
  void look_around_at(const Level& level, Index k, double reach, bool both_ways);
  [[nodiscard]] bool near_wall(Index k) const noexcept;
  void clear(Index k);
  void add(Index k, Neighbour neighbour) {
    List& list = lists_[k];
    if (list.count < List::kRoom && (list.traits & List::kLong) == 0 && neighbour.image == Image{}) {
      list.near[list.count++] = neighbour.disk;
    } else {
      add_to_long(k, neighbour);
    }
  }
  void add_to_long(Index k, Neighbour neighbour);
  void lengthen(Index k);
  void drop(Index k, Index disk);

  const Box& box_;
  const Array<Record>& records_;
  const Array<DiskId>& ids_;
  double shell_;
  double slack_;
  double leash_;
  ListSteps steps_;

  Array<List> lists_;
  std::vector<Long> long_;
  std::vector<Index> free_;  // places in long_

  double smallest_radius_ = 0;
  bool one_radius_ = true;
  std::vector<Level> levels_;
};

}  // namespace carom::fast
