// What the files of a finished run say of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/run/measurement.hpp"

namespace carom {

/// Numbers of a report.json.
struct RunResults {
  std::uint64_t disks = 0;
  std::optional<double> packing_fraction;
  double time = 0;
  std::uint64_t collisions = 0;
  std::uint64_t wall_collisions = 0;
  std::optional<double> temperature;  ///< kT
  std::optional<double> pressure;     ///< βP (1/length²)
  std::string digest;
};

/// Reads report.json of a run's directory. Throws Error naming the file and what is wrong with it.
RunResults read_run_results(const std::string& directory);

/// What was observed: observables/index.json of a run's directory and, with `tables`, the tables it names. Nothing
/// where the run observed nothing. Cells that are empty or no numbers are NaN; a table's row may be short. Throws Error
/// naming the file and what is wrong with it.
std::vector<Measurement> read_measurements(const std::string& directory, bool tables = true);

}  // namespace carom
