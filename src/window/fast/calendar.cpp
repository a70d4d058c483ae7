#include "calendar.hpp"

#include <utility>

namespace carom::fast {
namespace {

constexpr std::size_t kFew = 8;

bool comes_later(const Due& a, const Due& b) noexcept { return a.time > b.time; }

/// Sorts kFew events, latest first: each one's place is the number of those that are later, counted without a branch
/// that could be guessed wrong.
void sort_few(Due* events) noexcept {
  std::array<Due, kFew> unsorted;
  std::array<std::uint32_t, kFew> place{};
  for (std::size_t k = 0; k < kFew; ++k) unsorted[k] = events[k];
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
  (std::make_index_sequence<kFew>{});
  for (std::size_t k = 0; k < kFew; ++k) events[place[k]] = unsorted[k];
}

}  // namespace

void Calendar::start(double length, double width, std::size_t ring) {
  length_ = length;
  width_ = width;
  inverse_width_ = 1 / width;
  last_ = std::max(static_cast<std::int64_t>(length * inverse_width_), std::int64_t{1}) - 1;
  ring = std::min(ring, static_cast<std::size_t>(last_ + 1));
  current_ = -1;
  settled_ = -1;
  due_before_ = -1;
  lap_start_ = 0;
  pushed_ = 0;
  ring_.assign(ring, Bucket{});
  counts_.assign(ring, 0);
  spilled_.clear();
  free_.clear();
  beyond_.clear();
  due_.resize(4 * kFew + Bucket::kRoom);
  count_ = 0;
}

void Calendar::insert_due(Due event) {
  if (event.time == settled_) settled_ = -1;
  if (count_ == due_.size()) due_.resize(2 * count_);
  std::size_t place = count_++;  // most come late in the bucket of a few: from the end it is not far
  for (; place > 0 && due_[place - 1].time < event.time; --place) due_[place] = due_[place - 1];
  due_[place] = event;
}

void Calendar::spill(std::size_t slot) {
  std::uint32_t place;
  if (free_.empty()) {
    place = static_cast<std::uint32_t>(spilled_.size());
    spilled_.push_back(ring_[slot]);
  } else {
    place = free_.back();
    free_.pop_back();
    spilled_[place] = ring_[slot];
  }
  counts_[slot] = 0;
  ring_[slot].more = place + 1;
}

void Calendar::collect(const Bucket& bucket, std::uint8_t count, const Array<Record>& records) {
  if (count_ + count + 2 * kFew > due_.size()) due_.resize(2 * due_.size() + count);
  Due* const begin = due_.data() + count_;
  Due* end = begin;
  for (std::uint8_t k = 0; k < count; ++k) {
    const Index disk = bucket.disks[k];
    const Record& own = records[disk];
    const double time = own.next;
    *end = {time, disk};
    const bool comes = time < length_;
    const bool now = bucket_of(std::min(time, length_)) == current_;  // kNever fits no integer
    const Index partner = std::max(own.partner, 0);
    const Record& other = records[partner];
    const bool known = (own.partner == partner) & (partner < disk) & (other.partner == disk) & (other.next == time);
    end += static_cast<int>(comes & now & !known);
  }
  count_ += static_cast<std::size_t>(end - begin);
}

void Calendar::sort_due() {
  if (count_ > kFew) {
    std::sort(due_.begin(), due_.begin() + static_cast<std::ptrdiff_t>(count_), comes_later);
    return;
  }
  for (std::size_t k = 0; k < kFew; ++k) due_[count_ + k].time = -1;  // before all others, which is behind them
  sort_few(due_.data());
}

void Calendar::begin_lap(const Array<Record>& records) {
  lap_start_ = current_;
  std::vector<Index> waiting;
  waiting.swap(beyond_);
  --current_;  // what waits may belong into the bucket whose turn it is
  for (const Index disk : waiting) {
    const double time = records[disk].next;
    if (time < length_ && bucket_of(time) > current_) push(disk, time);
  }
  ++current_;
}

bool Calendar::turn(const Array<Record>& records) {
  while (current_ < last_) {
    ++current_;
    if (current_ - lap_start_ == static_cast<std::int64_t>(ring_.size())) begin_lap(records);
    const auto slot = static_cast<std::size_t>(current_ - lap_start_);
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
    due_before_ = static_cast<double>(current_ + 2) * width_;
    return true;
  }
  return false;
}

}  // namespace carom::fast
