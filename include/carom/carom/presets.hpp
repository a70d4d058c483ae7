// Scenes made from a few numbers: what `carom make` writes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "carom/io/scene_file.hpp"
#include "carom/state/scene.hpp"

namespace carom {

/// A gas of one or two kinds of disks. The first kind has diameter 1 and mass 1.
struct GasPreset {
  std::uint64_t disks = 1000;
  double packing = 0.5;    ///< packing fraction of all disks together
  double temperature = 1;  ///< kT
  std::uint64_t seed = 1;
  Boundary boundary = Boundary::periodic;
  double radius_ratio = 1;              ///< of the second kind to the first
  double mass_ratio = 1;                ///< of the second kind to the first
  std::optional<double> fraction = {};  ///< share of disks that are of the second kind; ½ if a ratio is not 1
  double aspect = 1;                    ///< height/width of the box
  GasStart start = GasStart::lattice;
};

/// Runs for 20 collisions a disk. Throws Error if a number is out of range; whether it fits is realize()'s to say.
SceneFile make_gas(const GasPreset& preset);

/// An oblique collision of two equal disks in the open plane, one of them at rest.
SceneFile make_two_disks();

/// Newton's cradle: touching equal disks in a row, one coming in, between two walls that send the pulse back.
/// `disks` at least 2.
SceneFile make_cradle(std::uint64_t disks = 5);

/// The break of a rack of 15 balls on a 9-foot pool table (metres, kilograms, seconds), without friction.
SceneFile make_break();

/// Galperin's billiard (Regul. Chaotic Dyn. 8, 375 (2003)): a wall, a light disk at rest, a disk heavier by
/// 100^(digits−1) coming in. Contacts of the two and wall hits of the light one add up to the first `digits`
/// digits of π. `digits` from 1 to 7: beyond, rounding would show.
SceneFile make_galperin(int digits);

/// A heavy large disk at rest in a gas of 1000 light small ones.
SceneFile make_brownian(std::uint64_t seed = 1);

}  // namespace carom
