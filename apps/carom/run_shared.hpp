// What `carom run` and `carom resume` have in common: options of long runs, progress, and how the end is told.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "carom/carom.hpp"

namespace carom::program {

/// How often a run is saved and how long it may take.
struct SavingOptions {
  std::optional<double> checkpoint_every;
  std::optional<double> checkpoint_minutes;
  std::optional<double> max_minutes;
};

/// --checkpoint-every and --checkpoint-minutes.
void add_checkpoints(CLI::App& command, SavingOptions& options);

/// Those, and --max-minutes.
void add_saving(CLI::App& command, SavingOptions& options);

/// Throws Error if a time is out of range, and UsageError if there is nowhere to save to.
void check_saving(const SavingOptions& options, bool saves);

/// Throws Error in a build without HDF5, "which `needs_it`".
void require_hdf5(const char* needs_it);

/// Throws Error unless the value, if there is one, is finite and greater than 0 (or 0 where that is allowed).
void require_time(const char* option, const std::optional<double>& value, bool zero_allowed);

/// Throws Error unless the number of collisions, if there is one, is one that a run can be told to end at.
void require_collisions(const std::optional<std::uint64_t>& value);

void apply(const SavingOptions& options, RunPlan& plan);

/// Does `work` with a plan that shows progress on a terminal, unless `quiet`, and heeds signals.
RunEnd with_progress(RunPlan& plan, bool quiet, const std::function<RunEnd()>& work);

/// Prints the report, says how the run ended if not as asked, and returns the exit code.
int conclude(const RunEnd& end, bool json, const std::string& out);

}  // namespace carom::program
