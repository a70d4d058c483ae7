#include "time_series.hpp"

namespace carom {
namespace {

void drop_every_second(std::vector<double>& values) {
  for (std::size_t k = 0; 2 * k < values.size(); ++k) values[k] = values[2 * k];
  values.resize((values.size() + 1) / 2);
}

}  // namespace

void TimeSeries::add(double time, double value) {
  if (seen_++ % stride_ != 0) return;
  if (times_.size() == kMostRows) {
    drop_every_second(times_);
    drop_every_second(values_);
    stride_ *= 2;  // seen before this one: kMostRows × the old stride, a multiple of the new one
  }
  times_.push_back(time);
  values_.push_back(value);
}

void TimeSeries::exchange(SumsExchange sums) {
  sums.numbers("times", times_);
  sums.numbers("values", values_);
  sums.number("seen", seen_);
  sums.number("stride", stride_);
}

}  // namespace carom
