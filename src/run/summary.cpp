#include "carom/run/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace carom {
namespace {

constexpr double kLargestOverlap = 1e-9;
constexpr double kSmallestDriftLimit = 1e-12;

std::optional<double> if_number(double value) { return std::isnan(value) ? std::nullopt : std::optional(value); }

std::optional<double> momentum_drift(const Simulation& simulation, const Frame& frame) {
  const Box& box = simulation.system().box;
  if (box.conserved_axes() == 0) return std::nullopt;
  const Vec2 change = momentum(simulation.system(), frame) - simulation.initial().momentum;
  const Vec2 conserved{box.conserves_momentum(0) ? change.x : 0, box.conserves_momentum(1) ? change.y : 0};
  const double scale = simulation.initial().momentum_scale;
  return scale > 0 ? length(conserved) / scale : 0;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// kT averaged over the time measured.
double mean_temperature(const Simulation& simulation, const Frame& frame) {
  const double now = temperature(simulation.system(), frame);
  if (simulation.system().physics.elastic()) return now;
  const State& start = simulation.window_start();
  const double in_flight = simulation.time() - start.clock.start;
  const double rest = 0.5 * (temperature(simulation.system(), start.disks) + now) * in_flight;
  return (simulation.measured().kT_integral + rest) / (simulation.time() - simulation.measured().start);
}

/// βP = N/A + W/(2 A kT t) with W the virial summed over the time t.
double virial_pressure(const Simulation& simulation, double duration, double kT) {
  const System& system = simulation.system();
  const double area = system.box.size.x * system.box.size.y;
  const double virial = sum(simulation.books().virial_of) / duration;
  return (static_cast<double>(system.size()) + virial / (2 * kT)) / area;
}

/// βP = Σ|J| / (length of all walls × t × kT).
double wall_pressure(const Simulation& simulation, double duration, double kT) {
  const Box& box = simulation.system().box;
  const double walls = 2 * ((box.reflecting(0) ? box.size.y : 0) + (box.reflecting(1) ? box.size.x : 0));
  return sum(simulation.books().wall_impulse_of) / (walls * duration * kT);
}

std::optional<double> pressure(const Simulation& simulation, const Frame& frame) {
  const Box& box = simulation.system().box;
  const double duration = simulation.time() - simulation.measured().start;
  if (!simulation.measured().started || !(duration > 0)) return std::nullopt;
  const double kT = mean_temperature(simulation, frame);
  if (!(kT > 0)) return std::nullopt;
  if (box.periodic(0) && box.periodic(1)) return virial_pressure(simulation, duration, kT);
  const bool walls_end = box.boundary[0] != Boundary::open && box.boundary[1] != Boundary::open;
  if (box.has_walls() && walls_end) return wall_pressure(simulation, duration, kT);
  return std::nullopt;
}

}  // namespace

Summary summarize(const Simulation& simulation) {
  const System& system = simulation.system();
  const Books& books = simulation.books();
  const State& start = simulation.window_start();
  std::optional<Frame> in_flight;  // a frame of its own only where there is none yet: it may be large
  const bool at_start = simulation.time() == start.clock.start;
  const Frame& frame = at_start ? start.disks : in_flight.emplace(simulation.frame());
  const double energy = kinetic_energy(system, frame);
  const double energy_before = simulation.initial().energy;
  const double eta = packing_fraction(system);

  Summary summary;
  summary.disks = system.size();
  if (eta > 0) summary.packing_fraction = eta;
  summary.time = simulation.time();
  summary.collisions = books.collisions;
  summary.wall_collisions = books.wall_collisions;
  summary.solver = simulation.solver().name();
  summary.simd = simulation.solver().simd();
  const Division division = simulation.division();
  summary.threads = division.threads;
  summary.patches = division.patches;
  summary.windows = simulation.windows();
  summary.windows_repaired = division.windows_repaired;
  summary.patches_repaired = division.patches_repaired;
  summary.duplicated_work = division.duplicated;
  summary.phases = division.phases;
  summary.ties = books.ties;
  summary.collapses = books.collapses;
  summary.busiest_disk_events = *std::max_element(books.events_of.begin(), books.events_of.end());
  summary.max_overlap = books.largest_overlap;
  summary.energy_drift = energy_before > 0 ? (energy - energy_before) / energy_before : 0;
  summary.momentum_drift = momentum_drift(simulation, frame);
  summary.elastic = system.physics.elastic();
  summary.temperature = if_number(temperature(system, frame));
  summary.pressure = pressure(simulation, frame);
  summary.digest = digest(frame);
  return summary;
}

std::vector<std::string> violations(const Summary& summary) {
  std::vector<std::string> found;
  if (summary.max_overlap > kLargestOverlap) {
    found.push_back(fmt::format("two disks overlapped by {:.3g} contact distances (allowed: {})", summary.max_overlap,
                                kLargestOverlap));
  }
  const double limit = std::max(kSmallestDriftLimit, 0x1p-52 * static_cast<double>(summary.busiest_disk_events));
  if (summary.elastic && !(std::abs(summary.energy_drift) <= limit)) {
    found.push_back(
        fmt::format("the energy drifted by {:.3g} of itself (allowed: {:.3g})", summary.energy_drift, limit));
  }
  return found;
}

std::vector<std::string> violations_at_window_start(const Simulation& simulation) {
  Summary summary;
  const Books& books = simulation.books();
  summary.elastic = simulation.system().physics.elastic();
  summary.max_overlap = books.largest_overlap;
  const double before = simulation.initial().energy;
  if (summary.elastic && before > 0) {
    summary.energy_drift = (kinetic_energy(simulation.system(), simulation.window_start().disks) - before) / before;
    summary.busiest_disk_events = *std::max_element(books.events_of.begin(), books.events_of.end());
  }
  return violations(summary);
}

}  // namespace carom
