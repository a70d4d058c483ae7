// The main job: a simulation run to its end, with its trajectory, its collision log, its checkpoints and its report in
// files; and gone on with after it was stopped.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "carom/io/checkpoint.hpp"
#include "carom/io/output_directory.hpp"
#include "carom/io/report.hpp"
#include "carom/run/settings.hpp"
#include "carom/run/simulation.hpp"
#include "carom/state/scene.hpp"

namespace carom {

/// How a run is to end and what it leaves behind.
struct RunPlan {
  RunSettings settings;  ///< with `until` or `collisions`
  SolverOptions solver;
  ParallelOptions parallel;
  std::optional<OutputDirectory> directory;    ///< for scene.toml, final.xyz, report.json, trajectory and checkpoints
  std::optional<std::string> collisions_file;  ///< a CSV file for the collision log
  std::optional<std::string> goes_on_from;     ///< the file of the checkpoint given to resume_run(), if there is one
  std::optional<double> checkpoint_every;      ///< simulated time between two checkpoints
  double checkpoint_minutes = 10;              ///< and time by the clock; there is always one at start and end (in
                                               ///< builds without HDF5 there are none)
  std::optional<double> max_minutes;           ///< the run ends at the first stop after this time by the clock
  std::string title;                           ///< of the scene
  std::string command;                         ///< as typed; goes into the report
  /// Called some times per window, once where windows are divided, with the share of the run that is done.
  std::function<void(double done, const Simulation& simulation)> progress;
  const std::atomic<bool>* interrupt = nullptr;  ///< stops the run when it becomes true
};

/// How a run ended.
struct RunEnd {
  RunRecord record;
  bool interrupted = false;  ///< then the record is that of the start of the window that was abandoned
  bool exhausted = false;    ///< a number of collisions was not reached: no two disks meet any more
  bool out_of_time = false;  ///< `max_minutes` were over
};

/// Runs `setup` as planned and writes what the plan names. Throws Error if the settings have neither `until` nor
/// `collisions`, or a file cannot be written; then the last checkpoint is still there. Ends early where the
/// certificate no longer holds. An older run in the directory goes when all is ready to begin.
RunEnd run_scene(Setup setup, const RunPlan& plan);

/// Goes on from a checkpoint, with the same bits as if the run had not been stopped. The plan's directory is that of
/// the run, its trajectory and `collisions_file` are shortened to what the checkpoint knows and appended to. Throws
/// Error as run_scene(), and if the plan's end lies before the checkpoint.
RunEnd resume_run(Checkpoint checkpoint, const RunPlan& plan);

}  // namespace carom
