// All observables of a run, as one observer: hands windows and frames to those that want them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "carom/observe/observable.hpp"
#include "carom/observe/registry.hpp"
#include "carom/run/settings.hpp"
#include "carom/run/simulation.hpp"

namespace carom {

/// Frames at times inside windows are made from the window's start and its collisions, never taken from the solver: so
/// they cost nothing but that, and have the same bits however the window was computed. Every observable gets its first
/// frame at the start of the first window measured, and then one each interval.
class ObservableSet final : public Observer {
 public:
  /// Throws Error with everything wrong in `specs`. `subject` is looked at during the call only, but its system must be
  /// the one of all windows and frames.
  ObservableSet(const std::vector<ObserveSpec>& specs, const Subject& subject);

  [[nodiscard]] bool empty() const noexcept { return members_.empty(); }

  /// Only frames inside windows and observables that look at collisions need them.
  [[nodiscard]] bool wants_collisions() const noexcept override { return wants_collisions_; }
  void on_window(const WindowRecord& window) override;

  /// A frame of a saved trajectory, for all observables. Throws Error if they cannot use it.
  void on_frame(const System& system, const Frame& frame);

  /// In the order of the specifications.
  [[nodiscard]] std::vector<Measurement> results() const;

  /// Throws Error when loading sums of other observables or options.
  void exchange(SumsExchange sums);

 private:
  struct Member {
    ObserveSpec spec;
    std::unique_ptr<Observable> observable;
    std::uint64_t frames = 0;  // handed out so far
    bool stopped = false;      // no more frames since …
    double stopped_at = 0;
  };

  [[nodiscard]] double next_frame(const Member& member) const noexcept;
  void stop_the_hurried(const WindowRecord& window);
  void hand_out_frames(const WindowRecord& window);

  std::vector<Member> members_;
  bool wants_collisions_ = false;
  bool started_ = false;
  double start_ = 0;  // of measuring
};

}  // namespace carom
