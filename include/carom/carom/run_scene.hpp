// The main job: a simulation run to its end, with its trajectory, its collision log and its report in files.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

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
  std::optional<OutputDirectory> directory;    ///< for scene.toml, final.xyz, report.json and the trajectory
  std::optional<std::string> collisions_file;  ///< a CSV file for the collision log
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
};

/// Runs `setup` as planned and writes what the plan names. Throws Error if the settings have neither `until` nor
/// `collisions`, or a file cannot be written; scene.toml is written before the run begins.
RunEnd run_scene(Setup setup, const RunPlan& plan);

}  // namespace carom
