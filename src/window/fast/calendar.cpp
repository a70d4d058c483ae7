#include "calendar.hpp"

namespace carom::fast {
namespace {

bool comes_later(const Due& a, const Due& b) noexcept { return a.time > b.time; }

/// Latest first. Buckets hold a handful: then each event's place is the number of those that are later, counted without
/// a branch that could be guessed wrong.
void sort_latest_first(std::vector<Due>& events) {
  constexpr std::size_t kFew = 12;
  const std::size_t count = events.size();
  if (count > kFew) {
    std::sort(events.begin(), events.end(), comes_later);
    return;
  }
  std::array<Due, kFew> unsorted;
  std::array<std::uint32_t, kFew> place{};
  std::copy(events.begin(), events.end(), unsorted.begin());
  for (std::size_t a = 1; a < count; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const std::uint32_t later = unsorted[a].time > unsorted[b].time ? 1 : 0;
      place[b] += later;
      place[a] += 1 - later;
    }
  }
  for (std::size_t k = 0; k < count; ++k) events[place[k]] = unsorted[k];
}

}  // namespace

void Calendar::start(double length, double width, std::size_t ring) {
  length_ = length;
  inverse_width_ = 1 / width;
  last_ = std::max(static_cast<std::int64_t>(length * inverse_width_), std::int64_t{1}) - 1;
  ring = std::min(ring, static_cast<std::size_t>(last_ + 1));
  current_ = -1;
  settled_ = -1;
  lap_start_ = 0;
  pushed_ = 0;
  ring_.assign(ring, Bucket{});
  counts_.assign(ring, 0);
  spilled_.clear();
  free_.clear();
  beyond_.clear();
  due_.clear();
}

void Calendar::insert_due(Due event) {
  if (event.time == settled_) settled_ = -1;
  const auto place = std::upper_bound(due_.begin(), due_.end(), event, comes_later);
  due_.insert(place, event);
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
  const std::size_t before = due_.size();
  due_.resize(before + count);
  Due* end = due_.data() + before;
  for (std::uint8_t k = 0; k < count; ++k) {
    const Index disk = bucket.disks[k];
    const double time = records[disk].next;
    *end = {time, disk};
    const bool comes = time < length_;
    const bool now = bucket_of(std::min(time, length_)) == current_;  // kNever fits no integer
    end += static_cast<int>(comes) & static_cast<int>(now);
  }
  due_.resize(static_cast<std::size_t>(end - due_.data()));
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
  due_.clear();
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
    if (due_.empty()) continue;
    sort_latest_first(due_);
    return true;
  }
  return false;
}

}  // namespace carom::fast
