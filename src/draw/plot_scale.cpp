#include "plot_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace carom::draw {
namespace {

constexpr double kLeastRelativeSpan = 1e-7;  // of the larger end: below that, labels could not be told apart
constexpr double kLargest = 1e290;           // what lies beyond is not shown: spans stay finite
constexpr double kShortRange = 0.7;          // decades
constexpr double kSmallestPositive = 1e-290;

// A step of 1, 2 or 5 times a power of ten, with at most `most` steps in `span`.
double round_step(double span, int most) {
  const double power = std::pow(10, std::floor(std::log10(span / most)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (span / (digit * power) <= most) return digit * power;
  }
  return 10 * power;
}

std::string with_true_minus(std::string digits) { return digits.front() == '-' ? "\u2212" + digits.substr(1) : digits; }

int power_of(double value) { return static_cast<int>(std::floor(std::log10(value) + 1e-9)); }

RichText power_of_ten(int exponent) { return RichText{}.plain("10").super(with_true_minus(std::to_string(exponent))); }

}  // namespace

void Extent::include(double value) noexcept {
  if (!(std::abs(value) <= kLargest)) return;
  low = empty ? value : std::min(low, value);
  high = empty ? value : std::max(high, value);
  empty = false;
}

AxisScale::AxisScale(const Extent& extent, bool logarithmic, double padding, int most_labels)
    : logarithmic_(logarithmic) {
  if (!extent.empty) {
    low_ = logarithmic ? std::log10(std::max(extent.low, kSmallestPositive)) : extent.low;
    high_ = logarithmic ? std::log10(std::max(extent.high, kSmallestPositive)) : extent.high;
  }
  const double least = std::max(kLeastRelativeSpan * std::max(std::abs(low_), std::abs(high_)), kSmallestPositive);
  if (!(high_ - low_ >= least)) {
    const double middle = 0.5 * low_ + 0.5 * high_;
    const double half = logarithmic ? 0.5 : middle == 0 ? 1 : std::max(0.1 * std::abs(middle), least);
    low_ = middle - half;
    high_ = middle + half;
  } else {
    const double more = padding * (high_ - low_);
    low_ -= more;
    high_ += more;
  }
  if (logarithmic) {
    add_logarithmic_ticks(most_labels);
  } else {
    add_linear_ticks(most_labels);
  }
}

bool AxisScale::has_place(double value) const noexcept {
  return std::abs(value) <= kLargest && (!logarithmic_ || value >= kSmallestPositive);
}

double AxisScale::place(double value) const noexcept {
  const double shown = logarithmic_ ? std::log10(value) : value;
  return (shown - low_) / (high_ - low_);
}

void AxisScale::add_linear_ticks(int most_labels) {
  const double step = round_step(high_ - low_, most_labels);
  const double largest = std::max(std::abs(low_), std::abs(high_));
  if (largest >= 1e5 || largest < 1e-2) exponent_ = power_of(largest);
  const double unit = std::pow(10, exponent_);
  const int decimals = std::clamp(-power_of(step / unit), 0, 15);
  const double first = std::ceil(low_ / step - 1e-9);
  for (double k = first; k * step <= high_ + 1e-9 * step; ++k) {
    const double value = k == 0 ? 0.0 : k * step / unit;
    ticks_.push_back({(k * step - low_) / (high_ - low_), true,
                      RichText{}.plain(with_true_minus(fmt::format("{:.{}f}", value, decimals)))});
  }
  constexpr int kMinor = 5;
  const double minor = step / kMinor;
  for (double k = std::ceil(low_ / minor - 1e-9); k * minor <= high_ + 1e-9 * minor; ++k) {
    if (std::fmod(std::abs(k), kMinor) != 0) ticks_.push_back({(k * minor - low_) / (high_ - low_), false});
  }
}

void AxisScale::add_logarithmic_ticks(int most_labels) {
  const double first = std::ceil(low_ - 1e-9), last = std::floor(high_ + 1e-9);
  if (last - first < 1) {
    return high_ - low_ < kShortRange ? add_round_ticks_of_short_range(most_labels) : add_digits_of_few_decades();
  }
  const double every = std::ceil((last - first + 1) / most_labels);
  for (double power = first - 1; power <= last; ++power) {
    const bool labelled = std::fmod(std::abs(power), every) == 0;
    const double place = (power - low_) / (high_ - low_);
    if (power >= first && (labelled || every <= 3)) {
      ticks_.push_back({place, labelled, labelled ? power_of_ten(static_cast<int>(power)) : RichText{}});
    }
    for (int digit = 2; every == 1 && digit <= 9; ++digit) {
      const double exact = (power + std::log10(digit) - low_) / (high_ - low_);
      if (exact >= 0 && exact <= 1) ticks_.push_back({exact, false});
    }
  }
}

// One power of ten or none in sight: 1, 2 and 5 times a power have labels, too.
void AxisScale::add_digits_of_few_decades() {
  for (double power = std::floor(low_); power <= high_; ++power) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double place = (power + std::log10(digit) - low_) / (high_ - low_);
      if (!(place >= 0 && place <= 1)) continue;
      const bool labelled = digit == 1 || digit == 2 || digit == 5;
      ticks_.push_back({place, labelled, labelled ? RichText{}.number(digit * std::pow(10, power)) : RichText{}});
    }
  }
}

// Less than a decade: round numbers, as on a linear axis, at their logarithms.
void AxisScale::add_round_ticks_of_short_range(int most_labels) {
  const double low = std::pow(10, low_), high = std::pow(10, high_);
  const double step = round_step(high - low, most_labels);
  for (double k = std::ceil(low / step); k * step <= high; ++k) {
    if (k <= 0) continue;
    ticks_.push_back({(std::log10(k * step) - low_) / (high_ - low_), true, RichText{}.number(k * step)});
  }
}

}  // namespace carom::draw
