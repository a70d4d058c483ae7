// Many runs of one scene with some of its numbers varied, as independent jobs on several threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "carom/io/scene_file.hpp"
#include "carom/io/sweep_files.hpp"
#include "carom/window/solver.hpp"

namespace carom {

/// How far a sweep is.
struct SweepProgress {
  double done = 0;  ///< share, 0 … 1, of all jobs
  std::uint64_t finished = 0;
  std::uint64_t jobs = 0;
  std::uint64_t collisions = 0;  ///< computed by this call
};

/// What a sweep is to do, and where it leaves its results.
struct SweepPlan {
  SceneFile file;  ///< whose run has `until` or `collisions`
  std::vector<VariedKey> varied;
  std::uint64_t replicas = 1;
  unsigned threads = 1;   ///< jobs at a time
  std::string directory;  ///< for sweep.json, sweep.csv, sweep_mean.csv, and a directory runs/NAME for each job
  SolverOptions solver;
  std::optional<double> checkpoint_every;  ///< simulated time between two checkpoints of a job
  double checkpoint_minutes = 10;          ///< and time by the clock (in builds without HDF5 there are none)
  std::string command;                     ///< as typed; goes into the reports
  /// Called about ten times a second from the caller's thread.
  std::function<void(const SweepProgress&)> progress;
  const std::atomic<bool>* interrupt = nullptr;  ///< stops all jobs when it becomes true
};

/// How a sweep ended.
struct SweepEnd {
  std::uint64_t jobs = 0;
  std::uint64_t kept = 0;     ///< that were finished by an earlier call
  std::uint64_t resumed = 0;  ///< that went on from a checkpoint of an earlier call
  bool interrupted = false;
  std::vector<SweepRow> rows;         ///< of finished jobs, in the order of jobs
  std::vector<std::string> damaged;   ///< "FILE: what is wrong with this checkpoint"; the one before it was taken
  std::vector<std::string> failures;  ///< "NAME: why that job could not be run"; then others may be missing
};

/// The jobs: all combinations of the values, the last key varying fastest, each with its replicas. Job j, counted from
/// 0, has for each gas the seed s + j, where s is the first 52 random bits of that gas's own seed; where seeds are
/// varied, the value itself. Throws Error if a key cannot be varied, or jobs would be copies of one another.
std::vector<SweepJob> jobs_of_sweep(const SweepPlan& plan);

/// Runs what is not finished yet and writes the tables: finished jobs are kept, others go on from their last
/// checkpoints. Every scene is checked before the first job begins. The tables are the same bytes for any number of
/// threads, and wherever and however often the sweep was stopped.
/// Throws Error if the directory holds another sweep, a scene cannot be simulated (all of them), or a file cannot be
/// written.
SweepEnd run_sweep(const SweepPlan& plan);

}  // namespace carom
