// The scenes that `carom bench` times, by name.
#pragma once

#include <string>
#include <vector>

#include "carom/carom/presets.hpp"

namespace carom::program {

/// One scene, and how long it is watched. Nothing of it depends on the machine: the same benchmark ends in the same
/// state, with the same digest, everywhere.
struct Benchmark {
  std::string name;
  std::string description;
  GasPreset gas;
  double collisions_per_disk = 0;  ///< that are timed, each counted for both of its disks
};

/// All of them, small ones first.
std::vector<Benchmark> all_benchmarks();

/// Those of at most 100,000 disks: what runs where nothing is named.
std::vector<Benchmark> short_benchmarks();

/// Those whose names begin with `name`, or all if it is "all". Throws UsageError that names the closest if there are
/// none.
std::vector<Benchmark> benchmarks_named(const std::string& name);

/// A periodic gas of equal disks of one's own choice. Throws UsageError for fewer than 2 disks, which never collide.
Benchmark benchmark_of_gas(std::uint64_t disks, double packing);

}  // namespace carom::program
