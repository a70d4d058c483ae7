// The files of a sweep: many runs of one scene with some of its numbers varied.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "carom/io/run_results.hpp"

namespace carom {

/// A number of the scene, and the values it takes.
struct VariedKey {
  std::string key;  ///< see set_scene_key()
  std::vector<double> values;

  friend bool operator==(const VariedKey&, const VariedKey&) = default;
};

/// All that decides what the jobs of a sweep compute. Kept in DIR/sweep.json.
struct SweepSettings {
  std::string scene;  ///< the scene file that is varied, in TOML
  std::vector<VariedKey> varied;
  std::uint64_t replicas = 1;
  std::string version;  ///< of carom
};

/// One job: which values it has, and with which seed. Kept in DIR/runs/NAME/job.json once it is finished.
struct SweepJob {
  std::string name;            ///< of its directory
  std::vector<double> values;  ///< one of each varied key
  std::uint64_t replica = 1;   ///< counted from 1
  std::uint64_t seed = 0;      ///< of the first gas
};

/// A finished job and what came out.
struct SweepRow {
  SweepJob job;
  std::optional<double> number_density;  ///< N/A (1/length²); absent where the box has no area
  RunResults results;
  std::vector<Measurement> measurements;  ///< estimates only
  std::vector<std::string> violations;    ///< why the run cannot be trusted; empty if all is well
};

/// What the jobs of one point have in common.
struct SweepMean {
  struct Quantity {
    std::string name;
    std::optional<double> mean;
    std::optional<double> error;  ///< standard error from the scatter of replicas; of a single one its own, if known
    std::string unit = {};
    std::optional<double> theory = {};  ///< mean of what it should be, where that is known for every replica
  };
  std::vector<double> values;  ///< of the varied keys
  std::uint64_t replicas = 0;  ///< that are finished
  std::vector<Quantity> quantities;
};

std::string sweep_settings_json(const SweepSettings& settings);
/// Throws Error naming the file if it is not one of these.
SweepSettings read_sweep_settings(const std::string& path);

/// Marks a job as finished; of the row's results only the digest is kept.
std::string finished_job_json(const SweepRow& row, const std::vector<VariedKey>& varied);

/// The results of a job in its directory; nothing where it is not finished: job.json or report.json is missing or
/// damaged, belongs to another job, or the two do not belong together.
std::optional<SweepRow> read_finished_job(const std::string& directory, const SweepJob& job);

/// Averages over the replicas of each point, in the order of the rows; rows of one point stand together.
std::vector<SweepMean> means_of(const std::vector<SweepRow>& rows);

/// One line per finished job: varied keys, replica, seed, disks, packing_fraction, time, collisions, temperature,
/// pressure, Z = pressure/number density, digest, then OBSERVABLE.ESTIMATE and its standard error for whatever was
/// observed. A varied key that is called like another column has its full name, gas.temperature. What has no value is
/// empty. Nothing in it depends on when or how fast the jobs ran.
std::string sweep_csv(const std::vector<VariedKey>& varied, const std::vector<SweepRow>& rows);

/// One line per point: varied keys, replicas, then the mean and the standard error of every number.
std::string sweep_mean_csv(const std::vector<VariedKey>& varied, const std::vector<SweepMean>& means);

}  // namespace carom
