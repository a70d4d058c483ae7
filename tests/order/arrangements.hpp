// Perfect lattices and random points, for tests.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "carom/base/random.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

inline constexpr std::array kPeriodic{Boundary::periodic, Boundary::periodic};
inline constexpr std::array kReflecting{Boundary::reflecting, Boundary::reflecting};
inline constexpr std::array kOpen{Boundary::open, Boundary::open};
inline constexpr std::array kMixed{Boundary::periodic, Boundary::reflecting};

/// Disks in a box, at rest.
struct Arrangement {
  System system;
  Frame frame;

  explicit Arrangement(Vec2 size, std::array<Boundary, 2> boundary = kPeriodic) { system.box = {size, boundary}; }
  void add(Vec2 position, double radius = 0.001, double mass = 1) {
    system.add_disk({radius, mass});
    frame.add_disk(position, {});
  }
};

/// columns × 2 rows2 sites of the triangular lattice at distance `spacing`, which its periodic box just holds.
inline Arrangement triangular_lattice(int columns, int rows2, double spacing) {
  const double height = spacing * std::sqrt(3.0) / 2;
  Arrangement lattice({columns * spacing, 2 * rows2 * height});
  for (int row = 0; row < 2 * rows2; ++row) {
    for (int column = 0; column < columns; ++column) {
      lattice.add({(column + (row % 2 == 0 ? 0.25 : 0.75)) * spacing, (row + 0.5) * height}, 0.4 * spacing);
    }
  }
  return lattice;
}

/// side × side sites of the square lattice.
inline Arrangement square_lattice(int side, double spacing, std::array<Boundary, 2> boundary = kPeriodic) {
  Arrangement lattice({side * spacing, side * spacing}, boundary);
  for (int k = 0; k < side * side; ++k) {
    lattice.add({(k % side + 0.5) * spacing, (k / side + 0.5) * spacing}, 0.4 * spacing);
  }
  return lattice;
}

/// Independent uniform points: an ideal gas.
inline Arrangement random_points(std::size_t count, Vec2 size, std::uint64_t seed,
                                 std::array<Boundary, 2> boundary = kPeriodic) {
  Arrangement points(size, boundary);
  RandomStream random(seed, 0, 77);
  for (std::size_t k = 0; k < count; ++k) {
    const double x = random.uniform() * size.x;
    points.add({x, random.uniform() * size.y}, 1e-9);
  }
  return points;
}

}  // namespace carom
