#include "frame_spacing.hpp"

#include <fmt/format.h>

#include <cmath>

#include "carom/base/error.hpp"

namespace carom {

void FrameSpacing::expect(double time) {
  const double tolerance = 1e-6 * spacing_ + 1e-15 * std::abs(time);
  if (started_ && !(std::abs(time - last_ - spacing_) <= tolerance)) {
    throw Error(
        fmt::format("{}: frames must be evenly spaced, but the one at time {} follows that at {} where {} is due",
                    observable_, time, last_, last_ + spacing_));
  }
  started_ = true;
  last_ = time;
}

void FrameSpacing::exchange(SumsExchange sums) {
  sums.number("spacing", spacing_);
  sums.number("started", started_);
  sums.number("last", last_);
}

}  // namespace carom
