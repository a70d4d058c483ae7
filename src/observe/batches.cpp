#include "carom/observe/batches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

constexpr std::size_t kMostBatches = 32;
constexpr std::size_t kFewestBatches = 4;  // for an error

double ratio(double sum, std::int64_t count) {
  return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
}

/// From a value without each of the batches.
std::optional<double> jackknife_error(const std::vector<double>& without) {
  if (without.size() < kFewestBatches) return std::nullopt;
  const auto n = static_cast<double>(without.size());
  double mean = 0;
  for (const double value : without) mean += value / n;
  double squares = 0;
  for (const double value : without) squares += (value - mean) * (value - mean);
  const double error = std::sqrt((n - 1) / n * squares);
  return std::isfinite(error) ? std::optional(error) : std::nullopt;
}

}  // namespace

Batches::Batches(std::size_t columns)
    : columns_(columns), sums_(kMostBatches * columns), counts_(kMostBatches * columns) {}

void Batches::end_sample() {
  ++samples_;
  if (++in_batch_ < batch_length_) return;
  in_batch_ = 0;
  filling_ += columns_;
  if (whole_batches() == kMostBatches) merge_pairs();
}

/// Batches become half as many, each twice as long.
void Batches::merge_pairs() {
  for (std::size_t batch = 0; batch < kMostBatches / 2; ++batch) {
    for (std::size_t column = 0; column < columns_; ++column) {
      const std::size_t first = 2 * batch * columns_ + column;
      sums_[batch * columns_ + column] = sums_[first] + sums_[first + columns_];
      counts_[batch * columns_ + column] = counts_[first] + counts_[first + columns_];
    }
  }
  filling_ = kMostBatches / 2 * columns_;
  std::fill(sums_.begin() + static_cast<std::ptrdiff_t>(filling_), sums_.end(), 0.0);
  std::fill(counts_.begin() + static_cast<std::ptrdiff_t>(filling_), counts_.end(), 0);
  batch_length_ *= 2;
}

std::uint64_t Batches::count(std::size_t column) const noexcept {
  std::int64_t count = 0;
  for (std::size_t at = column; at < counts_.size(); at += columns_) count += counts_[at];
  return static_cast<std::uint64_t>(count);
}

Batches::Value Batches::mean(std::size_t column) const {
  double sum = 0;
  std::int64_t count = 0;
  for (std::size_t at = column; at < sums_.size(); at += columns_) {
    sum += sums_[at];
    count += counts_[at];
  }
  std::vector<double> without;
  for (std::size_t at = column; at < filling_; at += columns_) {
    if (counts_[at] > 0) without.push_back(ratio(sum - sums_[at], count - counts_[at]));
  }
  return {ratio(sum, count), jackknife_error(without)};
}

Batches::Value Batches::of(const std::function<double(const std::vector<double>& means)>& function) const {
  std::vector<double> sums(columns_);
  std::vector<std::int64_t> counts(columns_);
  for (std::size_t at = 0; at < sums_.size(); ++at) {
    sums[at % columns_] += sums_[at];
    counts[at % columns_] += counts_[at];
  }
  std::vector<double> means(columns_);
  for (std::size_t column = 0; column < columns_; ++column) means[column] = ratio(sums[column], counts[column]);
  Value value{function(means)};
  std::vector<double> without;
  for (std::size_t batch = 0; batch < whole_batches(); ++batch) {
    for (std::size_t column = 0; column < columns_; ++column) {
      const std::size_t at = batch * columns_ + column;
      means[column] = ratio(sums[column] - sums_[at], counts[column] - counts_[at]);
    }
    without.push_back(function(means));
  }
  value.error = jackknife_error(without);
  return value;
}

void Batches::exchange(SumsExchange sums) {
  sums.number("samples", samples_);
  sums.number("batch_length", batch_length_);
  sums.number("in_batch", in_batch_);
  sums.number("filling", filling_);
  sums.numbers("sums", sums_);
  sums.numbers("counts", counts_);
}

}  // namespace carom
