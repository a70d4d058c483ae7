// The observables of a run, from its settings to its report and its files.
#pragma once

#include <optional>
#include <vector>

#include "carom/io/output_directory.hpp"
#include "carom/observe/observable_set.hpp"
#include "carom/run/measurement.hpp"
#include "carom/run/settings.hpp"
#include "carom/run/simulation.hpp"
#include "carom/state/scene.hpp"

namespace carom {

/// Made before the simulation, which it must outlive. Without observables it does nothing.
class Observed {
 public:
  /// Throws Error if a name or an option is wrong, or this system does not have what is asked for.
  Observed(const RunSettings& settings, const Setup& setup) : set_(settings.observe, {setup.system, setup.frame}) {}

  void watch(Simulation& simulation) {
    if (!set_.empty()) simulation.add_observer(set_);
  }

  /// What was found; with a directory, its files are written.
  [[nodiscard]] std::vector<Measurement> finish(const std::optional<OutputDirectory>& directory) const;

  /// Sums of all observables, for checkpoints.
  void exchange(SumsExchange sums) { set_.exchange(sums); }

 private:
  ObservableSet set_;
};

}  // namespace carom
