#include "past_frames.hpp"

#include <algorithm>

namespace carom {

PastFrames::PastFrames(std::size_t levels, std::size_t width) : levels_(levels), width_(width) {}

std::uint64_t PastFrames::lag(std::size_t number) const noexcept {
  if (number < kSlots) return number;
  const std::size_t level = (number - kSlots) / kUpper + 1;
  return ((number - kSlots) % kUpper + kUpper) << level;
}

void PastFrames::keep(std::size_t level, std::int64_t kept, std::span<const double> frame) {
  const std::size_t needed = (level + 1) * kSlots * width_;
  if (past_.size() < needed) past_.resize(needed);
  const std::span<const double> place = slot(level, kept);
  std::copy(frame.begin(), frame.end(), past_.begin() + (place.data() - past_.data()));
}

void PastFrames::exchange(SumsExchange sums) {
  sums.number("frames", frames_);
  sums.numbers("past", past_);
}

std::vector<std::size_t> evenly_chosen(std::size_t disks, std::size_t most) {
  const std::size_t count = std::min(disks, most);
  std::vector<std::size_t> chosen(count);
  for (std::size_t k = 0; k < count; ++k) chosen[k] = k * disks / count;
  return chosen;
}

}  // namespace carom
