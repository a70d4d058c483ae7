// One benchmark's scene, simulated and timed.
#pragma once

#include <atomic>
#include <cstdint>

#include "bench_catalogue.hpp"
#include "carom/run/parallel.hpp"
#include "carom/run/summary.hpp"
#include "carom/window/solver.hpp"

namespace carom::program {

/// What was measured. Times are of the wall clock, in seconds.
struct Measurement {
  double load_seconds = 0;          ///< making the scene and the simulation
  double first_window_seconds = 0;  ///< the first window, in which lists and calendar are built
  double seconds = 0;               ///< the windows that are timed
  std::uint64_t collisions = 0;     ///< of two disks in these windows
  std::uint64_t wall_collisions = 0;
  double bytes_per_disk = 0;  ///< the program's largest resident memory over the number of disks
  Summary summary;            ///< from time 0 to the end
};

/// Makes the scene, simulates 10 collisions a disk to bring it to equilibrium, then times whole windows until there
/// were `collisions_per_disk` more. Nothing observes the simulation. Shows a progress bar on a terminal. Throws Error
/// where the scene cannot be simulated, and Interrupted once `interrupt` is true.
Measurement measure(const Benchmark& benchmark, const SolverOptions& solver, const ParallelOptions& parallel,
                    const std::atomic<bool>& interrupt);

}  // namespace carom::program
