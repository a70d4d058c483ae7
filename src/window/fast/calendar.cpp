#include "calendar.hpp"

namespace carom::fast {
namespace {

bool comes_later(const Due& a, const Due& b) noexcept { return a.time > b.time; }

/// Latest first. Buckets hold a handful.
void sort_latest_first(std::vector<Due>& events) {
  constexpr std::size_t kFew = 24;
  if (events.size() > kFew) {
    std::sort(events.begin(), events.end(), comes_later);
    return;
  }
  for (std::size_t k = 1; k < events.size(); ++k) {
    const Due event = events[k];
    std::size_t place = k;
    for (; place > 0 && events[place - 1].time < event.time; --place) events[place] = events[place - 1];
    events[place] = event;
  }
}

}  // namespace

void Calendar::start(double length, double width, std::size_t ring) {
  inverse_width_ = 1 / width;
  last_ = std::max(static_cast<std::int64_t>(length * inverse_width_), std::int64_t{1}) - 1;
  ring = std::min(ring, static_cast<std::size_t>(last_ + 1));
  current_ = -1;
  settled_ = -1;
  lap_start_ = 0;
  pushed_ = 0;
  ring_.assign(ring, Bucket{});
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

void Calendar::spill(Bucket& line) {
  std::uint32_t place;
  if (free_.empty()) {
    place = static_cast<std::uint32_t>(spilled_.size());
    spilled_.push_back(line);
  } else {
    place = free_.back();
    free_.pop_back();
    spilled_[place] = line;
  }
  line.count = 0;
  line.more = place + 1;
}

void Calendar::collect(const Bucket& line, const Array<Record>& records) {
  for (std::uint32_t k = 0; k < line.count; ++k) {
    const double time = records[line.disks[k]].next;
    if (time < predict::kNever && bucket_of(time) == current_) due_.push_back({time, line.disks[k]});
  }
}

void Calendar::begin_lap(const Array<Record>& records) {
  lap_start_ = current_;
  std::vector<Index> waiting;
  waiting.swap(beyond_);
  --current_;  // what waits may belong into the bucket whose turn it is
  for (const Index disk : waiting) {
    const double time = records[disk].next;
    if (time < predict::kNever && bucket_of(time) > current_) push(disk, time);
  }
  ++current_;
}

bool Calendar::turn(const Array<Record>& records) {
  due_.clear();
  while (current_ < last_) {
    ++current_;
    if (current_ - lap_start_ == static_cast<std::int64_t>(ring_.size())) begin_lap(records);
    Bucket& line = ring_[static_cast<std::size_t>(current_ - lap_start_)];
    if (line.count == 0 && line.more == 0) continue;
    collect(line, records);
    for (std::uint32_t more = line.more; more != 0;) {
      const Bucket& spilled = spilled_[more - 1];
      collect(spilled, records);
      free_.push_back(more - 1);
      more = spilled.more;
    }
    line.count = 0;
    line.more = 0;
    if (due_.empty()) continue;
    sort_latest_first(due_);
    return true;
  }
  return false;
}

}  // namespace carom::fast
