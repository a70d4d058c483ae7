// How the events' loop finds whom a disk can meet: from lists, or from a grid of cells. Included by events-inl.hpp.
//
// Both answer the same questions:
//   gather        the disks that a disk can meet, and how closely one has to look at them
//   shift         which copies of them, where some are copies
//   note          what was found goes into the disk's record, or the grid event that comes before it
//   grid_event    the disk leaves the place where its neighbours were looked for
//   folded        the disk's stored position was folded into the box

CAROM_BEGIN
namespace carom::fast::CAROM_TARGET {

/// Disks near a disk, followed by the disk itself as often as a vector has lanes.
struct Candidates {
  static constexpr int kRoom = 64;
  alignas(64) std::array<Index, kRoom> room;  // also for what vector stores write beyond the last
  const Index* disks = room.data();
  int size = 0;
};

/// How gathered candidates have to be looked at.
enum class Look {
  plain,   ///< they are the disks at their stored positions
  copies,  ///< some are copies
  closer   ///< that is not all: ask Workspace::settled_contact
};

template <class Kernel, bool kOneKind>
class NearFromLists {
 public:
  /// Whether it pays to ask early for all that a prediction reads.
  static constexpr bool kReadsFar = false;

  explicit NearFromLists(Workspace& work)
      : work_(work),
        records_(work.records.data()),
        lists_(*work.lists),
        length_(work.length),
        leash_squared_(lists_.leash_squared()) {}

  CAROM_INLINE Look gather(Index k, Candidates& near) const {
    const List& list = lists_[k];
    near.size = list.count;
    if (list.count <= List::kReadable) {
      near.disks = list.near.data();
    } else {
      std::copy(list.near.begin(), list.near.end(), near.room.begin());
      Kernel::pad(k, near.room.data(), List::kRoom);
    }
    return list.traits == 0 ? Look::plain : list.traits == List::kLong ? Look::copies : Look::closer;
  }

  /// Returns false if that is not all there is to know.
  bool shift(Index k, Candidates& near, Shifts& shifts) const {
    near.size = 0;
    bool all = true;
    lists_.for_neighbours(k, [&](const Neighbour& neighbour) {
      if (near.size == Candidates::kRoom - 16) {
        all = false;
        return;
      }
      const bool first = work_.ids[k] < work_.ids[neighbour.disk];
      const Image copy = first ? neighbour.image : Image{-neighbour.image.x, -neighbour.image.y};
      shifts.set(near.size, copy, first, work_.system.box.size);
      near.room[near.size++] = neighbour.disk;
    });
    near.disks = near.room.data();
    Kernel::pad(k, near.room.data(), near.size);
    for (int m = near.size; m < near.size + Kernel::kLanesPerPass; ++m) shifts.set(m, {}, true, {});
    return all;
  }
  void set_partner_image(Index k, Image image) { lists_.set_partner_image(k, image); }
  [[nodiscard]] Image partner_image(Index k) const { return lists_.partner_image(k); }

  [[nodiscard]] std::uint32_t partner_events(Index k) const { return lists_[k].partner_events; }

  CAROM_INLINE void note(Index k, Nearest nearest) {
    Record& own = records_[k];
    List& list = lists_[k];
    const double leaves = leaves_list(own, list, nearest.time);
    own.partner = leaves <= nearest.time ? kGridEvent : nearest.partner;
    own.next = std::min(leaves, nearest.time);
    list.partner_events = records_[std::max(own.partner, 0)].events;
  }

  /// Returns false: the disk's contacts have to be looked for anew.
  bool grid_event(Index k, double time) {
    work_.renew_list(k, time);
    return false;
  }

  void folded(Index k, Image /*turns*/, double time) { work_.renew_list(k, time); }

  void prefetch(Index k) const { __builtin_prefetch(&lists_[k]); }

 private:
  /// When the disk has gone as far from its list's centre as it may; kNever if not before `time` or the window's end.
  CAROM_INLINE double leaves_list(const Record& own, const List& list, double time) const {
    const double limit = std::min(time, length_) - own.t;
    const double ex = own.x - list.x;
    const double ey = own.y - list.y;
    const double px = ex + own.vx * limit;
    const double py = ey + own.vy * limit;
    if (px * px + py * py < leash_squared_) return predict::kNever;
    const double v_squared = own.vx * own.vx + own.vy * own.vy;
    if (!(v_squared > 0)) return predict::kNever;
    const double b = ex * own.vx + ey * own.vy;
    const double c = leash_squared_ - (ex * ex + ey * ey);
    if (c <= 0 && b >= 0) return own.t;
    const double root = std::sqrt(std::max(b * b + v_squared * c, 0.0));
    return own.t + (b > 0 ? c / (b + root) : (root - b) / v_squared);
  }

  Workspace& work_;
  Record* records_;
  Lists& lists_;
  const double length_;
  const double leash_squared_;
};

template <class Kernel, bool kOneKind>
class NearFromCells {
 public:
  static constexpr bool kReadsFar = true;

  explicit NearFromCells(Workspace& work)
      : work_(work),
        records_(work.records.data()),
        cells_(*work.cells),
        length_(work.length),
        size_(work.system.box.size),
        low_(cells_.low()),
        width_(cells_.width()),
        row_stride_(cells_.row_stride()) {}

  /// From the nine cells around the disk.
  CAROM_INLINE Look gather(Index k, Candidates& near) {
    Place& place = cells_[k];
    const Index* rows = cells_.slots(place) - row_stride_ - Cells::kSlots;
    int size = 0;  // not near.size: what others may see, the compiler keeps in memory
    const bool plain = Kernel::template collect<3 * Cells::kSlots>(rows, row_stride_, k, near.room.data(), size);
    near.size = size;
    return look(k, place, near, plain);
  }

  /// Takes the marks off the candidates and says what they meant. Returns false if that is not all there is to know.
  bool shift(Index k, Candidates& near, Shifts& shifts) const {
    const Image own = cells_.turns(k);
    for (int m = 0; m < near.size; ++m) {
      const Index slot = near.disks[m];
      if (!Slot::says_all(slot)) return false;
      const Index other = Slot::disk(slot);
      const Image copy = Slot::image(slot);
      near.room[m] = other;
      shifts.set(m, {copy.x + own.x, copy.y + own.y}, work_.ids[k] < work_.ids[other], size_);
    }
    for (int m = near.size; m < near.size + Kernel::kLanesPerPass; ++m) shifts.set(m, {}, true, size_);
    return true;
  }
  void set_partner_image(Index k, Image image) { cells_.set_partner_image(k, image); }
  [[nodiscard]] Image partner_image(Index k) const { return cells_.partner_image(k); }

  [[nodiscard]] std::uint32_t partner_events(Index k) const { return cells_[k].partner_events; }

  CAROM_INLINE void note(Index k, const Nearest& nearest) {
    Place& place = cells_[k];
    place.contact = nearest.time;
    place.partner = nearest.partner;
    place.partner_events = records_[std::max(place.partner, 0)].events;
    note_first(k, place);
  }

  /// The disk crosses into the next cell. Whom it meets first is who it was, or somebody in the cells now near.
  /// Returns false if that has to be looked for anew.
  CAROM_INLINE bool grid_event(Index k, double time) {
    Place& place = cells_[k];
    if (work_.patched) work_.note_excursion(k, time);
    if (place.traits != Place::kPlain || !cross_inside(k, place)) {
      cells_.cross(k);
      if (place.traits != Place::kPlain) return false;
    }
    alignas(64) std::array<Index, Candidates::kRoom> near;
    const Index* const ahead = cells_.slots(place) + ahead_[place.exit];
    const std::ptrdiff_t across = across_[place.exit];
    int size = 0;
    const bool plain = Kernel::template collect<Cells::kSlots>(ahead - across, across, k, near.data(), size);
    if (!plain) return false;
    Kernel::pad(k, near.data(), size);
    const Nearest nearest = Kernel::template nearest<kOneKind>(records_, k, near.data(), size);
    if (nearest.time < place.contact) {
      if (nearest.tied) return false;
      cells_.set_partner_image(k, {});
      note(k, nearest);
      return true;
    }
    if ((nearest.time == place.contact) & (nearest.time < predict::kNever)) return false;
    note_first(k, place);
    return true;
  }

  void folded(Index k, Image turns, double /*time*/) { cells_.fold(k, turns); }

  void prefetch(Index k) const { __builtin_prefetch(&cells_[k], 1); }
  void prefetch_around(Index k, Index partner) const {
    const Place& place = cells_[k];
    const Index* const here = cells_.slots(place);
    if (partner < 0) {
      const Index* const ahead = here + ahead_[place.exit];
      const std::ptrdiff_t across = across_[place.exit];
      __builtin_prefetch(here, 1);
      __builtin_prefetch(ahead, 1);
      __builtin_prefetch(ahead - across);
      __builtin_prefetch(ahead + across);
    } else {
      prefetch_rows(here);
    }
  }
  void prefetch_candidates(Index k, Index partner) const {
    const Place& place = cells_[k];
    const Index* const here = cells_.slots(place);
    alignas(64) std::array<Index, Candidates::kRoom> near;
    int size = 0;
    if (partner < 0) {
      const std::ptrdiff_t across = across_[place.exit];
      Kernel::template collect<Cells::kSlots>(here + ahead_[place.exit] - across, across, k, near.data(), size);
    } else {
      prefetch_rows(cells_.slots(cells_[partner]));
      Kernel::template collect<3 * Cells::kSlots>(here - row_stride_ - Cells::kSlots, row_stride_, k, near.data(),
                                                  size);
    }
    for (int m = 0; m < size; ++m) __builtin_prefetch(&records_[Slot::disk(near[m])]);
  }

 private:
  CAROM_INLINE Look look(Index k, Place& place, Candidates& near, bool plain) {
    Kernel::pad(k, near.room.data(), near.size);
    if (plain & (place.traits == Place::kPlain)) return Look::plain;
    if (near.size > Candidates::kRoom - 16 || (place.traits & Place::kNearWall) != 0) return Look::closer;
    place.traits = static_cast<std::uint8_t>(place.traits & ~Place::kHasImage);
    return plain && place.traits == Place::kPlain ? Look::plain : Look::copies;
  }

  void prefetch_rows(const Index* here) const {
    constexpr int kLastSlot = 2 * Cells::kSlots - 1;  // in the third cell of a row
    const Index* row = here - row_stride_;
    for (int b = 0; b < 3; ++b, row += row_stride_) {
      __builtin_prefetch(row - Cells::kSlots);
      __builtin_prefetch(row + kLastSlot);
    }
  }

  /// The crossing or the contact, whichever comes first, goes into the record.
  CAROM_INLINE void note_first(Index k, Place& place) {
    Record& own = records_[k];
    const bool simple = (place.traits & (Place::kNearWall | Place::kElsewhere | Place::kAtCut)) == 0;
    const double crosses = simple ? crossing(own, place) : cells_.crossing_of_any(k);
    own.partner = crosses <= place.contact ? kGridEvent : place.partner;
    own.next = std::min(crosses, place.contact);
  }

  /// The usual crossing: from a cell inside the grid to another, neither of them crowded. Returns false, with nothing
  /// done, if it is not so.
  CAROM_INLINE bool cross_inside(Index k, Place& place) {
    const auto exit = static_cast<std::int32_t>(place.exit);  // left, right, bottom, top
    const std::int32_t step = 2 * (exit & 1) - 1;
    const std::int32_t upwards = exit >> 1;
    const std::int32_t column = place.column + step * (1 - upwards);
    const std::int32_t row = place.row + step * upwards;
    const int border = static_cast<int>(cells_.is_outermost(place.column, place.row)) |
                       static_cast<int>(cells_.is_outermost(column, row));
    Index* const from = cells_.slots(place);
    Index* const to = from + ahead_[place.exit];
    const unsigned here = Kernel::slots_with(from, k);
    const unsigned empty_there = Kernel::slots_with(to, Slot::kEmpty);
    const bool crowded = Kernel::slots_with(from, Slot::kEmpty) == 0;
    const int unusual = static_cast<int>(here == 0) | static_cast<int>(empty_there == 0) | static_cast<int>(crowded);
    if ((unusual | border) != 0) return false;
    from[std::countr_zero(here)] = Slot::kEmpty;
    to[std::countr_zero(empty_there)] = k;
    place.column = column;
    place.row = row;
    place.cell += static_cast<std::int32_t>(ahead_[place.exit]);
    return true;
  }

  /// When and where the disk leaves its cell, which lies inside the grid.
  CAROM_INLINE double crossing(const Record& own, Place& place) const {
    const int right = static_cast<int>(!(own.vx < 0));
    const int up = static_cast<int>(!(own.vy < 0));
    const double side = low_.x + width_.x * (place.column + right);
    const double top = low_.y + width_.y * (place.row + up);
    // At rest along an axis, + 0 makes it +0, and the time becomes infinity; or 0, which takes the disk off the side.
    const double through_side = std::max(0.0, (side - own.x) / (own.vx + 0.0));
    const double through_top = std::max(0.0, (top - own.y) / (own.vy + 0.0));
    place.exit = static_cast<std::uint8_t>(through_side <= through_top ? right : 2 + up);
    return own.t + std::min(through_side, through_top);
  }

  Workspace& work_;
  Record* records_;
  Cells& cells_;
  const double length_;
  const Vec2 size_;  // of the box
  const Vec2 low_, width_;
  const std::ptrdiff_t row_stride_;
  // By exit (left, right, bottom, top), in slots: to the cell beyond it, and from there to one beside.
  const std::array<std::ptrdiff_t, 4> ahead_{-Cells::kSlots, Cells::kSlots, -row_stride_, row_stride_};
  const std::array<std::ptrdiff_t, 4> across_{row_stride_, row_stride_, Cells::kSlots, Cells::kSlots};
};

}  // namespace carom::fast::CAROM_TARGET
CAROM_END
