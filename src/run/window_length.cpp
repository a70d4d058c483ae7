#include "carom/run/window_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

/// The fastest disk may fly through a periodic box this often in one window.
constexpr double kMostCrossings = 8;
constexpr double kLongest = 0x1p+250;
constexpr double kShortest = 0x1p-510;  // less than the highest speed takes across the smallest disk

double floor_to_power_of_two(double value) noexcept {
  int exponent = 0;
  std::frexp(std::clamp(value, kShortest, kLongest), &exponent);
  return std::ldexp(1.0, exponent - 1);
}

struct Motion {
  double fastest = 0;           // largest speed
  double root_mean_square = 0;  // of the speeds
};

Motion motion_of(const Frame& frame) noexcept {
  double squares = 0;
  double largest = 0;
  for (std::size_t k = 0; k < frame.size(); ++k) {
    const double square = dot(frame.velocity(k), frame.velocity(k));
    squares += square;
    largest = std::max(largest, square);
  }
  return {std::sqrt(largest), std::sqrt(squares / static_cast<double>(frame.size()))};
}

/// Longest window in which the fastest disk flies through a periodic box at most kMostCrossings times.
double longest_flight(const Box& box, double fastest) noexcept {
  double narrowest = std::numeric_limits<double>::infinity();
  if (box.periodic(0)) narrowest = std::min(narrowest, box.size.x);
  if (box.periodic(1)) narrowest = std::min(narrowest, box.size.y);
  return fastest > 0 ? kMostCrossings * narrowest / fastest : std::numeric_limits<double>::infinity();
}

/// Region that the disks share: the box, and where an axis is open what they take up now.
Vec2 occupied_region(const System& system, const Frame& frame) noexcept {
  Vec2 low = frame.position(0);
  Vec2 high = low;
  for (std::size_t k = 0; k < frame.size(); ++k) {
    low = {std::min(low.x, frame.x[k]), std::min(low.y, frame.y[k])};
    high = {std::max(high.x, frame.x[k]), std::max(high.y, frame.y[k])};
  }
  const double diameter = 2 * system.largest_radius();
  const Box& box = system.box;
  return {box.boundary[0] == Boundary::open ? high.x - low.x + diameter : box.size.x,
          box.boundary[1] == Boundary::open ? high.y - low.y + diameter : box.size.y};
}

/// Collisions per disk and time of a gas: Γ = 2 ρ d g √(π kT/m), with Henderson's g = (1 − 7η/16)/(1 − η)²
/// (Mol. Phys. 30, 971 (1975)), mean diameter d, and kT/m from half the mean square speed.
double gas_collision_rate(const System& system, const Frame& frame, double root_mean_square) noexcept {
  const Vec2 region = occupied_region(system, frame);
  const double area = region.x * region.y;
  double diameters = 0;
  double covered = 0;
  for (std::size_t k = 0; k < system.size(); ++k) {
    diameters += 2 * system.radius(k);
    covered += kPi * system.radius(k) * system.radius(k);
  }
  const double eta = std::min(covered / area, 0.9);
  const double g = (1 - 7 * eta / 16) / ((1 - eta) * (1 - eta));
  const double thermal = root_mean_square / std::sqrt(2.0);
  return 2 * (diameters / area) * g * std::sqrt(kPi) * thermal;
}

}  // namespace

double contacts_per_window(const System& system) noexcept {
  constexpr std::size_t kLarge = 100'000;  // disks from which on even one thread gains by patches
  constexpr double kDense = 0.65;
  if (system.size() < kLarge) return 16;
  return packing_fraction(system) < kDense ? 4 : 8;
}

double first_window_length(const System& system, const State& state) noexcept {
  const Motion motion = motion_of(state.disks);
  if (!(motion.fastest > 0)) return 1;
  const double rate = gas_collision_rate(system, state.disks, motion.root_mean_square);
  const double wanted = contacts_per_window(system) / rate;
  return floor_to_power_of_two(std::min(wanted, longest_flight(system.box, motion.fastest)));
}

double expected_contacts(const System& system, const State& state) noexcept {
  const Motion motion = motion_of(state.disks);
  if (!(motion.fastest > 0)) return 0;
  return gas_collision_rate(system, state.disks, motion.root_mean_square) * state.clock.length;
}

double next_window_length(const System& system, const State& after, std::uint64_t events) noexcept {
  const Clock& clock = after.clock;
  const double half = clock.length / 2;
  const double twice = clock.length * 2;
  const double longest = longest_flight(system.box, motion_of(after.disks).fastest);
  const double contacts = 2 * static_cast<double>(events) / static_cast<double>(system.size());
  const double wanted = contacts_per_window(system);
  const bool half_is_exact = half >= kShortest && (clock.start + half) - clock.start == half;
  if ((contacts > 2 * wanted || clock.length > longest) && half_is_exact) return half;
  const bool starts_on_twice = std::floor(clock.start / twice) * twice == clock.start;
  if (contacts < wanted / 3 && twice <= std::min(longest, kLongest) && starts_on_twice) return twice;
  return clock.length;
}

}  // namespace carom
