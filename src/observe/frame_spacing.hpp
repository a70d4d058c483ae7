// Frames that must come at equal distances.
#pragma once

#include <string_view>

#include "carom/run/sums.hpp"

namespace carom {

/// Holds the times of frames against their spacing.
class FrameSpacing {
 public:
  FrameSpacing(std::string_view observable, double spacing) : observable_(observable), spacing_(spacing) {}

  [[nodiscard]] double spacing() const noexcept { return spacing_; }
  /// Throws Error if this frame does not come one spacing after the last one, to 1e-6 of it.
  void expect(double time);
  void exchange(SumsExchange sums);

 private:
  std::string_view observable_;
  double spacing_;
  bool started_ = false;
  double last_ = 0;
};

}  // namespace carom
