// Frames of the past at lags that reach far with few of them kept.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "carom/run/sums.hpp"

namespace carom {

/// Level l keeps every 2^l-th of the frames it is given, the last 16 of those. So every frame that comes can be
/// compared with those 1 to 15 before it, every second one also with those 16, 18 … 30 before it, every fourth with 32,
/// 36 … 60, and so on. Every frame in turn is an origin. Frames are `width` numbers each.
class PastFrames {
 public:
  PastFrames(std::size_t levels, std::size_t width);

  /// Lags are numbered in growing order; number 0 is lag 0.
  [[nodiscard]] std::size_t lags() const noexcept { return kSlots + kUpper * (levels_ - 1); }
  /// In frames.
  [[nodiscard]] std::uint64_t lag(std::size_t number) const noexcept;
  /// Numbers of the shortest and the longest lag that level adds, the last but one factor of two apart.
  [[nodiscard]] std::size_t first_of_level(std::size_t level) const noexcept {
    return level == 0 ? kUpper : kSlots + kUpper * (level - 1);
  }
  [[nodiscard]] std::size_t last_of_level(std::size_t level) const noexcept {
    return first_of_level(level) + kUpper - 1;
  }
  [[nodiscard]] std::size_t levels() const noexcept { return levels_; }
  [[nodiscard]] std::uint64_t frames() const noexcept { return static_cast<std::uint64_t>(frames_); }

  /// Calls visit(number, past) for every lag, 0 included, that `frame` has a past frame at, and keeps it.
  template <typename Visit>
  void add(std::span<const double> frame, const Visit& visit) {
    visit(0, frame);
    for (std::size_t level = 0; level < levels_ && frames_ % (std::int64_t{1} << level) == 0; ++level) {
      const std::int64_t kept = frames_ >> level;
      for (std::size_t back = level == 0 ? 1 : kUpper; back < kSlots && std::cmp_less_equal(back, kept); ++back) {
        visit(number_of(level, back), slot(level, kept - static_cast<std::int64_t>(back)));
      }
      keep(level, kept, frame);
    }
    ++frames_;
  }

  void exchange(SumsExchange sums);

 private:
  static constexpr std::size_t kSlots = 16;
  static constexpr std::size_t kUpper = kSlots / 2;  // lags that a level above the lowest adds

  [[nodiscard]] static std::size_t number_of(std::size_t level, std::size_t back) noexcept {
    return level == 0 ? back : kSlots + kUpper * (level - 1) + (back - kUpper);
  }
  [[nodiscard]] std::span<const double> slot(std::size_t level, std::int64_t kept) const noexcept {
    return std::span(past_).subspan((level * kSlots + static_cast<std::size_t>(kept) % kSlots) * width_, width_);
  }
  void keep(std::size_t level, std::int64_t kept, std::span<const double> frame);

  std::size_t levels_;
  std::size_t width_;
  std::int64_t frames_ = 0;
  std::vector<double> past_;  // level by level, slot by slot; grows with the highest level in use
};

/// Σ term(k) over `count` numbers, in four sums that do not wait for one another and always come together in one order.
template <typename Term>
double sum_in_four(std::size_t count, const Term& term) {
  std::array<double, 4> sums{};
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += term(k + lane);
  }
  for (; k < count; ++k) sums[0] += term(k);
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// Which disks are followed where there are more than `most`: as many, evenly chosen.
std::vector<std::size_t> evenly_chosen(std::size_t disks, std::size_t most);

}  // namespace carom
