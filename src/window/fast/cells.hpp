// A grid of cells at least one contact distance wide: whom a disk can meet before it crosses into another cell is in
// the nine cells around it.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "carom/state/system.hpp"
#include "carom/window/collision.hpp"
#include "grid.hpp"
#include "huge_pages.hpp"
#include "neighbour.hpp"
#include "record.hpp"

namespace carom::fast {

/// Where a disk is in the grid, and its earliest contact; its record's event is that or a crossing before it.
struct alignas(32) Place {
  static constexpr std::uint8_t kPlain = 0;
  static constexpr std::uint8_t kNearWall = 1;   ///< in an outermost cell along an axis with walls
  static constexpr std::uint8_t kElsewhere = 2;  ///< has flown over a seam: its stored position is in another copy
  static constexpr std::uint8_t kHasImage = 4;   ///< its next contact is with a copy
  static constexpr std::uint8_t kAtCut = 8;      ///< in an outermost cell along an axis that is cut

  double contact;  ///< time of its earliest known contact; from the window's end on it does not count (time)
  Index partner;   ///< with whom
  std::uint32_t partner_events;  ///< the partner's contacts in this window when that was predicted
  std::int32_t column, row;
  std::int32_t cell;  ///< where the slots of the cell begin
  std::uint8_t traits;
  std::uint8_t exit;  ///< through which side it leaves the cell: as Wall
};
static_assert(sizeof(Place) == 32);

/// What stands in a slot: a disk; and where that is not the disk at its stored position but a copy of it, marked,
/// which.
class Slot {
 public:
  static constexpr Index kEmpty = -1;
  static constexpr Index kMarked = 1 << 30;
  static constexpr Index kMostDisks = 1 << 25;

  /// Disk k's copy at its stored position + image L. `look_closer`: the cell does not say all.
  static Index of(Index k, Image image, bool look_closer) noexcept {
    if (look_closer || image.x < -2 || image.x > 2 || image.y < -2 || image.y > 2) return k | kMarked | kLookCloser;
    if (image == Image{}) return k;
    return k | kMarked | (((image.x + 2) * 5 + image.y + 2) << kCodeShift);
  }
  [[nodiscard]] static Index disk(Index slot) noexcept { return slot & (kMostDisks - 1); }
  [[nodiscard]] static bool says_all(Index slot) noexcept {
    return slot < kMarked || (slot & kLookCloser) != kLookCloser;
  }
  [[nodiscard]] static Image image(Index slot) noexcept {
    if (slot < kMarked) return {};
    const Index code = (slot & kLookCloser) >> kCodeShift;
    return {code / 5 - 2, code % 5 - 2};
  }

 private:
  static constexpr int kCodeShift = 25;
  static constexpr Index kLookCloser = 31 << kCodeShift;
};

/// Around the cells of the box lies a border of cells, which along a periodic axis repeat those of the other side.
class Cells {
 public:
  static constexpr int kSlots = 5;

  /// Whether a grid like this can serve the system, or fewer than Slot::kMostDisks of its disks.
  static bool fit(const System& system, const Extent& extent, double slack);

  /// Cells of at least `width`, over `extent` where it is cut and over the box else.
  Cells(const System& system, const Extent& extent, double width, double slack, const Array<Record>& records,
        const Array<DiskId>& ids);

  [[nodiscard]] Place& operator[](Index k) noexcept { return places_[k]; }
  [[nodiscard]] const Place& operator[](Index k) const noexcept { return places_[k]; }

  /// Slots of a cell. Those of the next column follow; those of the next row come row_stride() later.
  [[nodiscard]] const Index* slots(std::int32_t column, std::int32_t row) const noexcept {
    return slots_.data() + number_of(column, row) * kSlots;
  }
  [[nodiscard]] Index* slots(std::int32_t column, std::int32_t row) noexcept {
    return slots_.data() + number_of(column, row) * kSlots;
  }
  [[nodiscard]] Index* slots(const Place& place) noexcept { return slots_.data() + place.cell; }
  [[nodiscard]] const Index* slots(const Place& place) const noexcept { return slots_.data() + place.cell; }
  [[nodiscard]] std::ptrdiff_t row_stride() const noexcept {
    return (static_cast<std::ptrdiff_t>(columns_) + 2) * kSlots;
  }
  [[nodiscard]] Vec2 width() const noexcept { return width_; }
  /// Where the first column and the first row begin (length).
  [[nodiscard]] Vec2 low() const noexcept { return low_; }
  /// Whether the cell is outermost in the box: it may have copies in the border.
  [[nodiscard]] bool is_outermost(std::int32_t column, std::int32_t row) const noexcept {
    // One comparison for both ends: what is below 0 becomes large.
    return (static_cast<std::uint32_t>(column - 1) >= static_cast<std::uint32_t>(columns_ - 2)) |
           (static_cast<std::uint32_t>(row - 1) >= static_cast<std::uint32_t>(rows_ - 2));
  }

  /// Calls visit(Neighbour) for every other disk in the nine cells around disk k.
  template <class Visit>
  void for_neighbours(Index k, Visit visit) const {
    const Place& place = places_[k];
    const Image turns_k = turns(k);
    for (int b = -1; b <= 1; ++b) {
      for (int a = -1; a <= 1; ++a) {
        std::int32_t column = place.column + a;
        std::int32_t row = place.row + b;
        Image seam;
        if (!step_over(column, columns_, 0, seam.x) || !step_over(row, rows_, 1, seam.y)) continue;
        for_disks_in(column, row, [&](Index other) {
          if (other == k) return;
          const Image turns_other = turns(other);
          Image image{seam.x + turns_k.x - turns_other.x, seam.y + turns_k.y - turns_other.y};
          if (image != Image{} && ids_[other] < ids_[k]) image = {-image.x, -image.y};
          visit(Neighbour{other, image});
        });
      }
    }
  }

  /// How many periods the disk's stored position is away from its place in the grid.
  [[nodiscard]] Image turns(Index k) const noexcept {
    return (places_[k].traits & Place::kElsewhere) == 0 ? Image{} : turns_.at(k);
  }
  [[nodiscard]] Image partner_image(Index k) const noexcept {
    return (places_[k].traits & Place::kHasImage) == 0 ? Image{} : partner_images_.at(k);
  }
  void set_partner_image(Index k, Image image);

  /// The time at which disk k leaves its cell; sets its `exit`.
  double crossing_of_any(Index k);
  /// Takes disk k into the cell beyond its exit.
  void cross(Index k);
  /// The disk's stored position has been folded into the box by so many periods; its place in the grid is the same.
  void fold(Index k, Image turns);

 private:
  /// Number of a cell, those of the border counted.
  [[nodiscard]] std::ptrdiff_t number_of(std::int32_t column, std::int32_t row) const noexcept {
    return (static_cast<std::ptrdiff_t>(row) + 1) * (static_cast<std::ptrdiff_t>(columns_) + 2) + column + 1;
  }
  bool step_over(std::int32_t& cell, std::int32_t count, int axis, std::int32_t& seam) const noexcept {
    if (cell >= 0 && cell < count) return true;
    if (!wraps_[axis]) return false;
    seam = cell < 0 ? -1 : 1;
    cell -= seam * count;
    return true;
  }
  template <class Visit>
  void for_disks_in(std::int32_t column, std::int32_t row, Visit visit) const {
    const Index* cell = slots(column, row);
    int taken = 0;
    for (int m = 0; m < kSlots; ++m) {
      if (cell[m] < 0) continue;
      visit(Slot::disk(cell[m]));
      ++taken;
    }
    if (taken < kSlots || surplus_.empty()) return;
    const auto found = surplus_.find(number_of(column, row));
    if (found == surplus_.end()) return;
    for (const Index disk : found->second) visit(disk);
  }
  void set_turns(Index k, Image turns);
  void note_edges(Index k) noexcept;
  void insert(Index k);
  void remove(Index k);
  void write_slot(std::int32_t column, std::int32_t row, unsigned slot, Index k, bool crowded) noexcept;
  void write_slots(std::int32_t column, std::int32_t row) noexcept;

  const Box& box_;
  const Array<Record>& records_;
  const Array<DiskId>& ids_;
  std::int32_t columns_ = 0, rows_ = 0;  // of the box, without the border
  Vec2 low_, width_;
  std::array<bool, 2> wraps_;                        // where the grid closes on itself
  std::array<std::array<std::uint8_t, 2>, 2> edge_;  // traits at the low and the high end of each axis
  Array<Index> slots_;
  Array<Place> places_;
  std::unordered_map<std::ptrdiff_t, std::vector<Index>> surplus_;  // disks that found no slot in their cell
  std::unordered_map<Index, Image> turns_;
  std::unordered_map<Index, Image> partner_images_;
};

}  // namespace carom::fast
