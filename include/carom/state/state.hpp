// What a run changes: where the disks are, how they move, and which window is next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "carom/base/vec2.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// All disks at one common time. Arrays of N, entry k belongs to disk k.
struct Frame {
  double time = 0;
  std::vector<double> x, y;                        ///< centres (length); wrap()ped along periodic axes
  std::vector<double> vx, vy;                      ///< velocities (length/time)
  std::vector<std::int64_t> winding_x, winding_y;  ///< how often each periodic seam was crossed, signed

  [[nodiscard]] std::size_t size() const noexcept { return x.size(); }
  [[nodiscard]] Vec2 position(std::size_t k) const noexcept { return {x[k], y[k]}; }
  [[nodiscard]] Vec2 velocity(std::size_t k) const noexcept { return {vx[k], vy[k]}; }
  void resize(std::size_t count);
  void add_disk(Vec2 position, Vec2 velocity);
};

/// Which window comes next, and what its length was chosen from. `length` is a power of two and `start` a
/// multiple of it, so that start + length is exact.
struct Clock {
  std::uint64_t window = 0;  ///< number of the window that starts here
  double start = 0;          ///< its start (time)
  double length = 1;         ///< its length (time)
};

/// Everything that decides the future, at the start of a window.
struct State {
  Frame disks;
  /// Time of each disk's last contact relative to the window's start, ≤ 0; −∞ if it had none. Empty in elastic systems.
  std::vector<double> last_contact;
  Clock clock;
};

/// One coordinate folded into the box, and how many L were taken off.
struct Wrapped {
  double coordinate = 0;
  std::int64_t turns = 0;
};

/// x − L floor(x/L); a result of L becomes 0. Rounding can leave it below 0 by some 1e-16 L.
Wrapped wrap(double coordinate, double period) noexcept;

/// Kinetic energy Σ ½ m v², summed in id order.
double kinetic_energy(const System& system, const Frame& frame) noexcept;

/// Σ m v, summed in id order.
Vec2 momentum(const System& system, const Frame& frame) noexcept;

/// Σ m |v|: what momentum drift is measured against.
double momentum_scale(const System& system, const Frame& frame) noexcept;

/// kT = 2E/f with velocities relative to the drift along conserved axes; NaN where f = 0.
double temperature(const System& system, const Frame& frame) noexcept;

/// XXH3 of the frame's time and of x, y, vx, vy and both windings of each disk in id order: 16 hexadecimal digits.
std::string digest(const Frame& frame);

/// XXH3 of what defines the dynamics: box, physics, radii, masses and the frame.
std::string digest(const System& system, const Frame& frame);

}  // namespace carom
