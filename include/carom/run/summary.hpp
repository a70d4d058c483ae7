// What a run reports about itself: its certificate, temperature and pressure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/run/simulation.hpp"

namespace carom {

/// A run up to simulation.time(). Quantities without a value (no drift to speak of, no degrees of freedom,
/// an open plane) are absent.
struct Summary {
  std::uint64_t disks = 0;
  std::optional<double> packing_fraction;  ///< absent where the box has no area
  double time = 0;
  std::uint64_t collisions = 0;       ///< of two disks
  std::uint64_t wall_collisions = 0;  ///< of a disk and a wall

  std::string solver;
  std::string simd;
  std::uint64_t threads = 1;
  std::uint64_t patches = 1;
  std::uint64_t windows = 0;
  std::uint64_t windows_repaired = 0;  ///< in which a patch had to be advanced again with more around it
  std::uint64_t patches_repaired = 0;
  double duplicated_work = 0;  ///< contacts computed more than once, of those that count
  Division::Phases phases;     ///< of divided windows

  std::uint64_t ties = 0;
  std::uint64_t collapses = 0;            ///< contacts made elastic by the TC rule
  std::uint64_t busiest_disk_events = 0;  ///< contacts of the disk that had most
  double max_overlap = 0;                 ///< in contact distances
  double energy_drift = 0;                ///< (E − E0)/E0; with restitution below 1 the energy lost, negative
  std::optional<double> momentum_drift;   ///< |Δ Σ m v| / Σ m|v| at time 0, over conserved axes
  bool elastic = true;

  std::optional<double> temperature;  ///< kT = 2E/f
  std::optional<double> pressure;  ///< βP (1/length²): virial in periodic boxes, mean wall pressure where there are
                                   ///< walls, absent where an axis is open
  std::string digest;              ///< of the frame at `time`
};

/// Summary of everything up to simulation.time().
Summary summarize(const Simulation& simulation);

/// What keeps the run from being trusted: an overlap above 1e-9 contact distances, or in an elastic system an energy
/// drift above max(1e-12, 2⁻⁵² × contacts of the busiest disk). Empty if all is well.
std::vector<std::string> violations(const Summary& summary);

/// The same at the start of a window, without all else that a summary tells: quick enough to be asked in every window.
std::vector<std::string> violations_at_window_start(const Simulation& simulation);

}  // namespace carom
