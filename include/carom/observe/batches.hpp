// Errors of many means at once, and of functions of them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "carom/run/sums.hpp"

namespace carom {

/// Sums of columns (bins of a histogram, lags of a correlation), kept apart for 16 to 31 batches of successive samples.
/// What is computed from all batches but one tells the error by the jackknife. A batch grows with the run; the errors
/// hold once it is longer than the correlation of the samples.
class Batches {
 public:
  explicit Batches(std::size_t columns);

  /// Adds a value to a column; a sample may have any number of values for a column, or none.
  void add(std::size_t column, double value) {
    sums_[filling_ + column] += value;
    ++counts_[filling_ + column];
  }
  /// Ends the sample that add() was called for.
  void end_sample();

  [[nodiscard]] std::uint64_t samples() const noexcept { return static_cast<std::uint64_t>(samples_); }
  [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
  /// Values that a column has.
  [[nodiscard]] std::uint64_t count(std::size_t column) const noexcept;

  struct Value {
    double value = 0;                  ///< NaN where there are no values
    std::optional<double> error = {};  ///< absent for fewer than 4 batches
  };
  /// Mean of a column.
  [[nodiscard]] Value mean(std::size_t column) const;
  /// A function of the columns' means, NaN for columns without values.
  [[nodiscard]] Value of(const std::function<double(const std::vector<double>& means)>& function) const;

  void exchange(SumsExchange sums);

 private:
  [[nodiscard]] std::size_t whole_batches() const noexcept { return filling_ / columns_; }
  void merge_pairs();

  std::size_t columns_;
  std::int64_t samples_ = 0;
  std::int64_t batch_length_ = 1;  // in samples
  std::int64_t in_batch_ = 0;      // samples in the one being filled
  std::size_t filling_ = 0;        // where its columns begin
  // Batch by batch, column by column.
  std::vector<double> sums_;
  std::vector<std::int64_t> counts_;
};

}  // namespace carom
