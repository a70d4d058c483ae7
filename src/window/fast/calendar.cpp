#include "calendar.hpp"

#include <bit>
#include <limits>
#include <utility>

namespace carom::fast {
namespace {

constexpr std::size_t kFew = 8;
constexpr std::size_t kCachedBuckets = 4096;
constexpr std::int64_t kFarAhead = 32;
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

bool comes_later(const Due& a, const Due& b) noexcept { return a.time > b.time; }

/// Sorts kCount events, latest first: each one's place is the number of those that are later, counted without a branch
/// that could be guessed wrong.
template <std::size_t kCount>
void sort_few(Due* events) noexcept {
  std::array<Due, kCount> unsorted;
  std::array<std::uint32_t, kCount> place{};
  for (std::size_t k = 0; k < kCount; ++k) unsorted[k] = events[k];
  const auto compare = [&](std::size_t a, std::size_t b) {
    const std::uint32_t later = unsorted[a].time > unsorted[b].time ? 1 : 0;
    place[b] += later;
    place[a] += 1 - later;
  };
  const auto compare_with_those_before = [&]<std::size_t a, std::size_t... b>(std::index_sequence<a>,
                                                                              std::index_sequence<b...>) {
    (compare(a, b), ...);
  };
  [&]<std::size_t... a>(std::index_sequence<a...>) {
    (compare_with_those_before(std::index_sequence<a>{}, std::make_index_sequence<a>{}), ...);
  }
  (std::make_index_sequence<kCount>{});
  for (std::size_t k = 0; k < kCount; ++k) events[place[k]] = unsorted[k];
}

}  // namespace

void Calendar::start(double length, double width, std::size_t ring) {
  length_ = length;
  width_ = width;
  inverse_width_ = 1 / width;
  last_ = std::max(static_cast<std::int64_t>(length * inverse_width_), std::int64_t{1}) - 1;
  ring = std::bit_ceil(std::min(ring, static_cast<std::size_t>(last_ + 1)) + 1);
  mask_ = static_cast<std::int64_t>(ring) - 1;
  current_ = -1;
  settled_ = -1;
  pushed_ = 0;
  ring_.assign(ring, Bucket{});
  counts_.assign(ring, 0);
  spilled_.clear();
  free_.clear();
  beyond_.clear();
  far_ahead_ = ring > kCachedBuckets ? kFarAhead : kNever;
  later_.fill({});
  needed_by_ = kNever;
  due_.resize(4 * kFew + Bucket::kRoom);
  due_[0] = {predict::kNever, -1};
  count_ = 0;
}

void Calendar::put_all_that_wait() {
  for (Later& event : later_) {
    if (event.disk >= 0) put(event.disk, event.bucket);
    event.disk = -1;
  }
  needed_by_ = kNever;
}

void Calendar::push_elsewhere(Index disk, double time) {
  if (bucket_of(time) <= current_) {
    insert_due({time, disk});
  } else {
    beyond_.push_back(disk);
  }
}

void Calendar::insert_due(Due event) {
  if (event.time == settled_) settled_ = -1;
  if (count_ + 1 == due_.size()) due_.resize(2 * due_.size());
  std::size_t place = ++count_;  // the bucket of a few: from the end it is not far
  for (; due_[place - 1].time < event.time; --place) due_[place] = due_[place - 1];
  due_[place] = event;
}

/// Puts a full bucket aside and begins another.
void Calendar::spill(std::size_t slot, Index disk) {
  std::uint32_t place;
  if (free_.empty()) {
    place = static_cast<std::uint32_t>(spilled_.size());
    spilled_.push_back(ring_[slot]);
  } else {
    place = free_.back();
    free_.pop_back();
    spilled_[place] = ring_[slot];
  }
  ring_[slot].more = place + 1;
  ring_[slot].disks[0] = disk;
  counts_[slot] = 1;
}

void Calendar::collect(const Bucket& bucket, std::uint8_t count, const Array<Record>& records) {
  if (count_ + count + 2 * kFew > due_.size()) due_.resize(2 * due_.size() + count);
  Due* const begin = due_.data() + 1 + count_;
  Due* end = begin;
  const double length = length_;
  const std::int64_t current = current_;
  for (std::uint8_t k = 0; k < count; ++k) {
    const Index disk = bucket.disks[k];
    const double time = records[disk].next;
    *end = {time, disk};
    const bool now = bucket_of(std::min(time, length)) == current;  // infinity fits no integer
    end += static_cast<int>((time < length) & now);
  }
  count_ += static_cast<std::size_t>(end - begin);
}

void Calendar::sort_due() {
  Due* const begin = due_.data() + 1;
  if (count_ > kFew) {
    std::sort(begin, begin + count_, comes_later);
    return;
  }
  for (std::size_t k = 0; k < kFew; ++k) begin[count_ + k].time = -1;  // before all others, which is behind them
  if (count_ > kFew / 2) {
    sort_few<kFew>(begin);
  } else {
    sort_few<kFew / 2>(begin);
  }
}

/// Once the ring has gone round, what lay beyond it is entered again: it lies in this lap or beyond the next.
void Calendar::begin_lap(const Array<Record>& records) {
  std::vector<Index> waiting;
  waiting.swap(beyond_);
  for (const Index disk : waiting) {
    const double time = records[disk].next;
    if (!(time < length_)) continue;
    const std::int64_t bucket = bucket_of(time);
    if (bucket < current_) continue;
    if (bucket - current_ <= mask_) {
      put(disk, bucket);
    } else {
      beyond_.push_back(disk);
    }
  }
}

bool Calendar::turn(const Array<Record>& records) {
  while (current_ < last_) {
    ++current_;
    if (current_ >= needed_by_) put_all_that_wait();
    if ((current_ & mask_) == 0) begin_lap(records);
    const auto slot = static_cast<std::size_t>(current_ & mask_);
    Bucket& bucket = ring_[slot];
    if (counts_[slot] == 0 && bucket.more == 0) continue;
    collect(bucket, counts_[slot], records);
    for (std::uint32_t more = bucket.more; more != 0;) {
      const Bucket& spilled = spilled_[more - 1];
      collect(spilled, Bucket::kRoom, records);
      free_.push_back(more - 1);
      more = spilled.more;
    }
    counts_[slot] = 0;
    bucket.more = 0;
    if (count_ == 0) continue;
    sort_due();
    return true;
  }
  return false;
}

}  // namespace carom::fast
