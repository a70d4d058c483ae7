#include "run_shared.hpp"

#include <fmt/format.h>

#include <cmath>

#include "command.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "progress.hpp"

namespace carom::program {

void add_checkpoints(CLI::App& command, SavingOptions& options) {
  add_number(command, "--checkpoint-every", options.checkpoint_every, "simulated time between two checkpoints");
  add_number(command, "--checkpoint-minutes", options.checkpoint_minutes,
             "minutes between two checkpoints, 10 by default; there is one at the start and one at the end");
}

void add_saving(CLI::App& command, SavingOptions& options) {
  add_checkpoints(command, options);
  add_number(command, "--max-minutes", options.max_minutes,
             "end the run after so many minutes; carom resume goes on with it");
}

void require_time(const char* option, const std::optional<double>& value, bool zero_allowed) {
  if (!value) return;
  const bool fits = std::isfinite(*value) && (zero_allowed ? *value >= 0 : *value > 0);
  if (!fits)
    throw Error(fmt::format("{} {}: it must be a finite time, {}", option, *value,
                            zero_allowed ? "0 or more" : "greater than 0"));
}

void require_collisions(const std::optional<std::uint64_t>& value) {
  if (value == 0) throw Error("--collisions 0: it must be greater than 0");
  if (value > kMostCollisions) {
    throw Error(fmt::format("--collisions {}: it must not be greater than {}", *value, kMostCollisions));
  }
}

void require_hdf5(const char* needs_it) {
  if (!has_checkpoints()) throw Error(fmt::format("this carom was built without HDF5, which {}", needs_it));
}

void check_saving(const SavingOptions& options, bool saves) {
  require_time("--checkpoint-every", options.checkpoint_every, false);
  require_time("--checkpoint-minutes", options.checkpoint_minutes, false);
  require_time("--max-minutes", options.max_minutes, false);
  const bool asked = options.checkpoint_every || options.checkpoint_minutes;
  if (asked) require_hdf5("checkpoints need");
  if (saves) return;
  if (options.checkpoint_every) throw UsageError("--checkpoint-every goes with --out DIR");
  if (options.checkpoint_minutes) throw UsageError("--checkpoint-minutes goes with --out DIR");
}

void apply(const SavingOptions& options, RunPlan& plan) {
  plan.checkpoint_every = options.checkpoint_every;
  if (options.checkpoint_minutes) plan.checkpoint_minutes = *options.checkpoint_minutes;
  plan.max_minutes = options.max_minutes;
}

RunEnd with_progress(RunPlan& plan, bool quiet, const std::function<RunEnd()>& work) {
  ProgressBar bar(!quiet);
  if (bar.visible()) {
    plan.progress = [&bar](double done, const Simulation& simulation) {
      bar.show({done, simulation.time(), simulation.books().collisions});
    };
  }
  plan.interrupt = &catch_interrupts();
  RunEnd end = work();
  bar.clear();
  return end;
}

int conclude(const RunEnd& end, bool json, const std::string& out) {
  print(json ? report_json(end.record) : report_text(end.record));
  const Summary& summary = end.record.summary;
  const std::string where = out.empty() || !has_checkpoints() ? "" : fmt::format("; carom resume {} goes on", out);
  if (end.exhausted) {
    tell(fmt::format("no two disks meet any more: the run ended at {} collisions", summary.collisions));
  }
  if (end.out_of_time) tell(fmt::format("the minutes are over: this is the state at time {}{}", summary.time, where));
  const std::vector<std::string> broken = violations(summary);
  for (const std::string& violation : broken) tell("DO NOT TRUST THIS RUN: " + violation);
  if (end.interrupted) {
    tell(fmt::format("interrupted; this is the state at time {}, the start of the window in flight{}", summary.time,
                     where));
    return kInterrupted;
  }
  return broken.empty() ? kSuccess : kFailure;
}

}  // namespace carom::program
