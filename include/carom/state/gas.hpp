// Initial states of a gas: where its disks start, and how fast. Bits depend on the seed alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "carom/base/vec2.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// A disk that takes up room before others are placed.
struct Obstacle {
  Vec2 position;
  double radius = 0;
};

/// Places found for a number of disks: all of them, or as many as this start can place.
struct Placement {
  std::vector<Vec2> positions;
  /// A factor by which all radii can be multiplied so that all disks find a place: at least 1 if they were placed,
  /// less if not, 0 where the start cannot say.
  double room = 0;
};

/// Sites of the triangular lattice that leaves most room among those with at least `count` free sites in the box,
/// chosen evenly; for disks of at most `radius`, clear of walls and obstacles.
Placement place_on_lattice(const Box& box, std::size_t count, double radius, std::span<const Obstacle> obstacles);

/// Random sequential addition: the largest disks first, each at a uniform place that is free. Gives up a disk after
/// 20,000 misses; then `positions` holds those placed so far, in the order of placing.
Placement place_at_random(const Box& box, std::span<const double> radii, std::uint64_t seed,
                          std::span<const Obstacle> obstacles);

/// Maxwell velocities for disks `first` … of the system, at kT = temperatures[k] for disk first + k. The disks of one
/// temperature have zero total momentum and exactly their share of energy: f/2N kT each, f the system's degrees of
/// freedom. A disk alone with its temperature keeps the velocity that was drawn.
void draw_velocities(const System& system, std::size_t first, std::span<const double> temperatures, std::uint64_t seed,
                     Frame& frame);

}  // namespace carom
