// The progress bar of `carom run`: on stderr, only on a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace carom::program {

/// How far a run is, and how its end is known.
struct Progress {
  double done = 0;  ///< share of the run, 0 … 1
  double time = 0;  ///< simulated
  std::uint64_t collisions = 0;
  std::string place = {};  ///< shown instead of the time if it is not empty
};

/// Draws one line and draws it again at most ten times a second; takes it away when destroyed.
class ProgressBar {
 public:
  /// Shows nothing unless stderr is a terminal and `wanted`.
  explicit ProgressBar(bool wanted);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  [[nodiscard]] bool visible() const noexcept { return visible_; }
  void show(const Progress& progress);
  /// Takes the line away.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool visible_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_{};
};

/// The bar as text, `columns` wide at most; `seconds` since the start.
std::string progress_line(const Progress& progress, double seconds, int columns);

}  // namespace carom::program
