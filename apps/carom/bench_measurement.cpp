#include "bench_measurement.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <fstream>

#include "carom/base/error.hpp"
#include "carom/run/simulation.hpp"
#include "carom/state/scene.hpp"
#include "command.hpp"
#include "progress.hpp"

namespace carom::program {
namespace {

constexpr double kCollisionsPerDiskToEquilibrate = 10;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Gives back the memory of the scene before and starts the kernel's account of the largest anew. Where the kernel does
/// not allow that, the account is that of the largest scene so far.
void restart_memory_account() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

std::uint64_t collisions_for(double per_disk, std::uint64_t disks) {
  const double collisions = std::ceil(0.5 * per_disk * static_cast<double>(disks));
  if (collisions >= 0x1p53) throw Error(fmt::format("{} collisions a disk are too many to wait for", per_disk));
  return static_cast<std::uint64_t>(collisions);
}

/// Runs whole windows of a simulation, timing nothing but them.
class TimedWindows {
 public:
  TimedWindows(Simulation& simulation, std::uint64_t expected_collisions)
      : simulation_(simulation), expected_(static_cast<double>(expected_collisions)) {}

  /// Seconds that the next window took.
  double run_one() {
    const Clock::time_point start = Clock::now();
    const Simulation::Stop stop = simulation_.run_window();
    const double seconds = seconds_since(start);
    if (stop == Simulation::Stop::interrupted) throw Interrupted();
    const std::uint64_t collisions = simulation_.books().collisions;
    bar_.show({static_cast<double>(collisions) / expected_, simulation_.time(), collisions});
    return seconds;
  }

  /// Seconds until the simulation has had so many collisions since time 0.
  double run_to(std::uint64_t collisions) {
    double seconds = 0;
    while (simulation_.books().collisions < collisions) seconds += run_one();
    return seconds;
  }

 private:
  Simulation& simulation_;
  double expected_;
  ProgressBar bar_{true};
};

}  // namespace

Measurement measure(const Benchmark& benchmark, const SolverOptions& solver, const ParallelOptions& parallel,
                    const std::atomic<bool>& interrupt) {
  const std::uint64_t disks = benchmark.gas.disks;
  const std::uint64_t untimed = collisions_for(kCollisionsPerDiskToEquilibrate, disks);
  const std::uint64_t timed = collisions_for(benchmark.collisions_per_disk, disks);

  Measurement measured;
  restart_memory_account();
  const Clock::time_point start = Clock::now();
  Simulation simulation(realize(make_gas(benchmark.gas).scene), solver, parallel);
  measured.load_seconds = seconds_since(start);
  simulation.stop_when(interrupt);

  TimedWindows windows(simulation, untimed + timed);
  measured.first_window_seconds = windows.run_one();
  windows.run_to(untimed);
  const Books& books = simulation.books();
  const std::uint64_t collisions_before = books.collisions;
  const std::uint64_t wall_collisions_before = books.wall_collisions;
  measured.seconds = windows.run_to(collisions_before + timed);
  measured.collisions = books.collisions - collisions_before;
  measured.wall_collisions = books.wall_collisions - wall_collisions_before;
  measured.bytes_per_disk = peak_bytes() / static_cast<double>(disks);
  measured.summary = summarize(simulation);
  return measured;
}

}  // namespace carom::program
