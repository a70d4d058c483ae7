#include "carom/observe/blocking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

constexpr std::int64_t kFewestSamples = 4;

}  // namespace

void Blocking::add(double sample) {
  double block = sample;
  for (std::size_t level = 0;; ++level) {
    if (level == count_.size()) {
      count_.push_back(0);
      for (auto* column : {&mean_, &squares_, &waiting_}) column->push_back(0);
    }
    const std::int64_t count = ++count_[level];
    const double deviation = block - mean_[level];
    mean_[level] += deviation / static_cast<double>(count);
    squares_[level] += deviation * (block - mean_[level]);
    if (count % 2 == 1) {
      waiting_[level] = block;
      return;
    }
    block = 0.5 * (waiting_[level] + block);
  }
}

Blocking::Result Blocking::result() const {
  Result result;
  if (count_.empty()) {
    result.mean = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  const auto variance_of_mean = [this](std::size_t level) {
    const auto n = static_cast<double>(count_[level]);
    return squares_[level] / (n * (n - 1));
  };
  result.mean = mean_[0];
  result.samples = static_cast<std::uint64_t>(count_[0]);
  if (count_[0] < kFewestSamples) return result;
  const double uncorrelated = variance_of_mean(0);
  double variance = uncorrelated;
  double length = 1;
  for (std::size_t level = 0; level < count_.size() && count_[level] >= kFewestSamples; ++level, length *= 2) {
    const double here = variance_of_mean(level);
    const double growth = uncorrelated > 0 ? here / uncorrelated : 1;
    const bool plateau = length * length * length > 2 * static_cast<double>(count_[0]) * growth * growth;
    if (plateau && count_[level] >= kFewestBlocks) {
      result.blocks = static_cast<std::uint64_t>(count_[level]);
      variance = here;
      break;
    }
    variance = std::max(variance, here);
  }
  result.error = std::sqrt(variance);
  if (uncorrelated > 0) result.correlation = std::max(0.0, 0.5 * (variance / uncorrelated - 1));
  return result;
}

void Blocking::exchange(SumsExchange sums) {
  sums.numbers("count", count_);
  sums.numbers("mean", mean_);
  sums.numbers("squares", squares_);
  sums.numbers("waiting", waiting_);
}

}  // namespace carom
