// The event calendar: buckets of a few events each, filled in any order, sorted when their turn comes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "huge_pages.hpp"
#include "record.hpp"

namespace carom::fast {

/// An event to come: which disk's, and when.
struct Due {
  double time = 0;
  Index disk = 0;
};

/// Holds the disks whose next event comes in a bucket; the time itself is in the disk's record. An entry whose disk
/// has another event by now is dropped when its bucket's turn comes, or when it is taken.
///
/// Buckets ahead of the current one stand in a ring; events beyond the ring wait until the ring has gone round once.
/// A contact that is the next event of both its disks needs to be entered for one of them only; whoever changes the
/// event of that one must then enter the other.
class Calendar {
 public:
  /// Empties the calendar for a window of this length, with buckets of this width, at least `ring` of them at hand.
  void start(double length, double width, std::size_t ring);

  /// Enters the disk's event at `time`, before the window's end.
  void push(Index disk, double time) {
    ++pushed_;
    const std::int64_t bucket = bucket_of(time);
    if (static_cast<std::uint64_t>(bucket - current_ - 1) >= static_cast<std::uint64_t>(mask_)) {
      push_elsewhere(disk, time);
      return;
    }
    if (bucket - current_ < far_ahead_) {
      put(disk, bucket);
    } else {
      put_later(disk, bucket);
    }
  }

  // --- the events of the current bucket ---------------------------------------------------------------------

  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  [[nodiscard]] Due first() const noexcept { return due_[count_]; }
  void drop_first() noexcept { --count_; }
  /// Whether another event comes at the time of the first one.
  [[nodiscard]] bool is_tied() const noexcept { return due_[count_ - 1].time == due_[count_].time; }
  template <class Visit>
  void for_due(Visit visit) const {
    for (std::size_t k = 1; k <= count_; ++k) visit(due_[k].disk);
  }

  /// Makes the next bucket that holds events the current one, sorts it, and returns true; false at the window's end.
  bool turn(const Array<Record>& records);

  /// Puts the events of the first one's time into the order given by `comes_before(disk, disk)`, and drops those out of
  /// date. Returns false if nothing had to be done.
  template <class ComesBefore>
  bool settle_tie(const Array<Record>& records, ComesBefore comes_before) {
    const double time = first().time;
    if (settled_ == time) return false;
    const auto end = due_.begin() + 1 + static_cast<std::ptrdiff_t>(count_);
    auto begin = end;
    while ((begin - 1)->time == time) --begin;
    const auto kept = std::remove_if(begin, end, [&](const Due& e) { return records[e.disk].next != time; });
    std::sort(begin, kept, [&](const Due& a, const Due& b) { return comes_before(b.disk, a.disk); });
    count_ = static_cast<std::size_t>(kept - due_.begin()) - 1;
    settled_ = time;
    return true;
  }

  /// Disks of a bucket some turns ahead, for prefetching.
  template <class Visit>
  void peek(std::int64_t ahead, Visit visit) const {
    if (current_ + ahead > last_ || ahead > mask_) return;
    const auto slot = static_cast<std::size_t>((current_ + ahead) & mask_);
    const Bucket& bucket = ring_[slot];
    for (int k = 0; k < counts_[slot]; ++k) visit(bucket.disks[k]);
  }

  /// Events entered so far.
  [[nodiscard]] std::uint64_t pushed() const noexcept { return pushed_; }

 private:
  struct alignas(64) Bucket {
    static constexpr std::uint8_t kRoom = 15;
    std::uint32_t more = 0;  // 1 + place in spilled_ of a full bucket's worth
    std::array<Index, kRoom> disks{};
  };
  static_assert(sizeof(Bucket) == 64);

  [[nodiscard]] std::int64_t bucket_of(double time) const noexcept {
    return std::min(static_cast<std::int64_t>(time * inverse_width_), last_);
  }
  /// Puts the disk into a bucket that stands in the ring.
  void put(Index disk, std::int64_t bucket) {
    // The counts stand apart from the buckets: they are few enough to stay in the cache, and nothing need wait for the
    // bucket's line to arrive.
    const auto slot = static_cast<std::size_t>(bucket & mask_);
    const std::uint8_t count = counts_[slot];
    if (count == Bucket::kRoom) {
      spill(slot, disk);
      return;
    }
    ring_[slot].disks[count] = disk;
    counts_[slot] = static_cast<std::uint8_t>(count + 1);
  }
  /// Where the ring is larger than the cache: asks for the bucket's line and puts the disk into it some entries later.
  /// The processor keeps the order of what it writes, so that all would wait for the line.
  void put_later(Index disk, std::int64_t bucket) {
    __builtin_prefetch(&ring_[static_cast<std::size_t>(bucket & mask_)], 1);
    Later& oldest = later_[next_later_];
    if (oldest.disk >= 0) put(oldest.disk, oldest.bucket);
    oldest = {disk, bucket};
    next_later_ = (next_later_ + 1) % later_.size();
    needed_by_ = std::min(needed_by_, bucket);
  }
  void put_all_that_wait();
  void push_elsewhere(Index disk, double time);
  void insert_due(Due event);
  void spill(std::size_t slot, Index disk);
  void collect(const Bucket& bucket, std::uint8_t count, const Array<Record>& records);
  void begin_lap(const Array<Record>& records);
  void sort_due();

  double length_ = 0;  // of the window
  double width_ = 0;
  double inverse_width_ = 0;
  std::int64_t last_ = -1;     // bucket of the window
  std::int64_t current_ = -1;  // bucket whose events are due
  std::int64_t mask_ = 0;      // the ring's size, a power of two, minus one
  std::uint64_t pushed_ = 0;
  std::int64_t far_ahead_ = 0;  // from so many buckets ahead on, a bucket may not be in the cache
  Array<Bucket> ring_;
  Array<std::uint8_t> counts_;  // of disks in each bucket of the ring
  std::vector<Bucket> spilled_;
  std::vector<std::uint32_t> free_;  // places in spilled_
  std::vector<Index> beyond_;        // disks whose event lies beyond the ring

  struct Later {
    Index disk = -1;
    std::int64_t bucket = 0;
  };
  std::array<Later, 16> later_;  // events on their way into their buckets, in a ring
  std::size_t next_later_ = 0;
  std::int64_t needed_by_ = 0;  // no bucket of later_ comes before it

  std::vector<Due> due_;  // one at infinity, then count_ that are due, latest first; the rest is room
  std::size_t count_ = 0;
  double settled_ = -1;  // time of the tie whose events are in order
};

}  // namespace carom::fast
