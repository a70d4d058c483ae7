// A quantity over time, thinned out as the run goes on.
#pragma once

#include <cstdint>
#include <vector>

#include "carom/run/sums.hpp"

namespace carom {

/// Keeps every n-th value; n doubles whenever that would be more than kMostRows. The first value is always kept.
class TimeSeries {
 public:
  static constexpr std::size_t kMostRows = 1024;

  void add(double time, double value);

  [[nodiscard]] const std::vector<double>& times() const noexcept { return times_; }
  [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }

  void exchange(SumsExchange sums);

 private:
  std::vector<double> times_;
  std::vector<double> values_;
  std::uint64_t seen_ = 0;
  std::uint64_t stride_ = 1;
};

}  // namespace carom
