// What generated scenes are made of, and the functions that make each group.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "carom/base/random.hpp"
#include "generated_scenes.hpp"
#include "scenes.hpp"

namespace carom::test {

GeneratedScenes gases();
GeneratedScenes dense_lattices();
GeneratedScenes mixtures();
GeneratedScenes granular();
GeneratedScenes tied_lattices();
GeneratedScenes symmetric();
GeneratedScenes touching();
GeneratedScenes uneven_speeds();
GeneratedScenes pistons();
GeneratedScenes long_flights();
GeneratedScenes narrow_boxes();
GeneratedScenes elongated_boxes();
GeneratedScenes open_plane();
GeneratedScenes units();
GeneratedScenes large();

using Boundaries = std::array<Boundary, 2>;

/// All nine combinations.
inline const std::vector<Boundaries>& all_boundaries() {
  static const std::vector<Boundaries> all = [] {
    constexpr std::array kEach{Boundary::periodic, Boundary::reflecting, Boundary::open};
    std::vector<Boundaries> made;
    for (const Boundary x : kEach) {
      for (const Boundary y : kEach) made.push_back({x, y});
    }
    return made;
  }();
  return all;
}

/// "periodic-open".
inline std::string name_of(const Boundaries& boundary) {
  return std::string(carom::name_of(boundary[0])) + "-" + std::string(carom::name_of(boundary[1]));
}

inline RandomStream random_for(std::uint64_t seed) {
  constexpr std::uint32_t kPurpose = 77;  // apart from the streams that carom itself draws from
  return {seed, 0, kPurpose};
}

/// Uniform in [low, high).
inline double between(RandomStream& random, double low, double high) { return low + random.uniform() * (high - low); }

inline Vec2 normal_velocity(RandomStream& random) {
  const double x = random.normal();
  return {x, random.normal()};
}

/// An empty scene.
inline Scene in_box(Vec2 size, const Boundaries& boundary) {
  Scene scene;
  scene.size = size;
  scene.boundary = boundary;
  return scene;
}

inline GasSpec some_disks(std::uint64_t count, double radius, double mass, std::uint64_t seed,
                          GasStart start = GasStart::random) {
  GasSpec spec;
  spec.count = count;
  spec.radius = radius;
  spec.mass = mass;
  spec.seed = seed;
  spec.start = start;
  return spec;
}

/// Gives the explicit disks ids in random order, so that neighbours do not have neighbouring ids.
inline void shuffle_ids(Scene& scene, RandomStream& random) {
  for (std::size_t k = scene.disks.size(); k > 1; --k) std::swap(scene.disks[k - 1], scene.disks[random.below(k)]);
}

/// Turns velocities along open axes towards the box's middle, so that there is something to meet.
void turn_inwards(Setup& setup);

struct LatticeShape {
  int columns = 1;
  int rows = 1;
  double spacing = 1;
};

/// Velocity of the disk in a column and a row.
using VelocityOf = std::function<Vec2(int column, int row)>;

/// A triangular lattice of disks of diameter 1 that just fits its box; an even number of rows.
Scene triangular_lattice(const LatticeShape& shape, const Boundaries& boundary, const VelocityOf& velocity);

/// A square lattice of disks of diameter 1 that just fits its box.
Scene square_lattice(const LatticeShape& shape, const Boundaries& boundary, const VelocityOf& velocity);

}  // namespace carom::test
