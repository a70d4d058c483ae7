// The one interface of everything that is measured during a run or from a saved trajectory.
#pragma once

#include <string_view>

#include "carom/run/measurement.hpp"
#include "carom/run/simulation.hpp"
#include "carom/run/sums.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// Sees a run and changes nothing. What it finds depends on windows, collisions and frames in their order alone, so it
/// has the same bits for any solver, number of patches and threads. Made for one system.
class Observable {
 public:
  virtual ~Observable() = default;

  [[nodiscard]] virtual std::string_view name() const noexcept = 0;

  /// Time between the frames it wants, the first at the start of measuring; 0 if it wants none.
  [[nodiscard]] virtual double interval() const noexcept { return 0; }
  /// Whether it looks at the single collisions of windows.
  [[nodiscard]] virtual bool wants_collisions() const noexcept { return false; }

  /// Every whole window that is measured, in order.
  virtual void on_window(const WindowRecord& /*window*/) {}
  /// All disks at one of the times it wants, in order; also every frame of a saved trajectory.
  virtual void on_frame(const System& /*system*/, const Frame& /*frame*/) {}

  /// What was found so far. Does not change what comes later.
  [[nodiscard]] virtual Measurement result() const = 0;

  /// Names every sum that decides how it goes on: saved by a checkpoint, loaded when resuming.
  virtual void exchange(SumsExchange sums) = 0;
};

}  // namespace carom
