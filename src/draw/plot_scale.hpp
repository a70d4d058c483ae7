// The scale of an axis: which numbers it shows, where, and which of them have ticks.
#pragma once

#include <vector>

#include "text.hpp"

namespace carom::draw {

/// The least and the largest number of those included.
struct Extent {
  double low = 0;
  double high = 0;
  bool empty = true;

  void include(double value) noexcept;
  [[nodiscard]] double span() const noexcept { return high - low; }
};

struct Tick {
  double place = 0;  ///< along the axis, from 0 to 1
  bool major = true;
  RichText label = {};  ///< of some major ticks
};

/// How numbers are laid along an axis.
class AxisScale {
 public:
  /// Shows at least what `extent` holds, with `padding` (a share of its span) on both sides. A logarithmic scale needs
  /// an extent above 0. Nothing to show: from 0 to 1. `most_labels` at least 2.
  AxisScale(const Extent& extent, bool logarithmic, double padding, int most_labels);

  /// From 0 to 1 for what is shown; outside for what is not. The caller guarantees `shows(value)` is defined.
  [[nodiscard]] double place(double value) const noexcept;
  /// Whether the number has a place: finite, and positive on a logarithmic scale.
  [[nodiscard]] bool has_place(double value) const noexcept;
  [[nodiscard]] bool logarithmic() const noexcept { return logarithmic_; }
  [[nodiscard]] double low() const noexcept { return low_; }
  [[nodiscard]] const std::vector<Tick>& ticks() const noexcept { return ticks_; }
  /// Labels are to be multiplied by ten to this power.
  [[nodiscard]] int exponent() const noexcept { return exponent_; }

 private:
  void add_linear_ticks(int most_labels);
  void add_logarithmic_ticks(int most_labels);
  void add_digits_of_few_decades();
  void add_round_ticks_of_short_range(int most_labels);

  bool logarithmic_;
  double low_ = 0;
  double high_ = 1;
  int exponent_ = 0;
  std::vector<Tick> ticks_;
};

}  // namespace carom::draw
