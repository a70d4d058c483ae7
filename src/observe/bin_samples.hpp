// The means of many numbers that are sampled together, such as the bins of a histogram, each with its error.
#pragma once

#include <cstddef>
#include <vector>

#include "carom/observe/blocking.hpp"
#include "carom/run/measurement.hpp"
#include "carom/run/sums.hpp"

namespace carom {

/// A Blocking per bin.
class BinSamples {
 public:
  explicit BinSamples(std::size_t bins) : bins_(bins) {}

  [[nodiscard]] std::size_t size() const noexcept { return bins_.size(); }
  /// One sample of every bin. The caller guarantees size() numbers.
  void add(const std::vector<double>& samples);
  void add(std::size_t bin, double sample) { bins_[bin].add(sample); }

  [[nodiscard]] Blocking::Result result(std::size_t bin) const { return bins_[bin].result(); }

  /// Appends the means to `columns`, and their errors as the column "NAME_error"; NaN where there is none.
  void append_to(std::vector<Column>& columns, const Column& heading) const;

  /// All bins in a few arrays, so that a checkpoint does not have one entry per bin.
  void exchange(SumsExchange sums);

 private:
  std::vector<Blocking> bins_;
};

}  // namespace carom
