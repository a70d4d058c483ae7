// When a run's checkpoints are due, and how they are kept.
#pragma once

#include <chrono>
#include <optional>

#include "carom/io/checkpoint.hpp"
#include "carom/io/output_directory.hpp"

namespace carom {

/// Keeps the last two checkpoints of a run in its directory.
class CheckpointKeeper {
 public:
  /// `every`: in simulated time, `minutes`: by the clock; whichever comes first.
  CheckpointKeeper(OutputDirectory directory, std::optional<double> every, double minutes, double now);

  /// Whether one is due in a run that stands at the start of a window at time `now`.
  [[nodiscard]] bool due(double now) const noexcept;
  /// Throws Error if it cannot be written; the ones before it are still there then.
  void save(const Checkpoint& checkpoint);

 private:
  using WallClock = std::chrono::steady_clock;

  OutputDirectory directory_;
  std::optional<double> every_;
  std::chrono::duration<double> pause_;
  double last_time_;
  WallClock::time_point last_saved_ = WallClock::now();
};

}  // namespace carom
