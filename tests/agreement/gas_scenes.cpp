// Gases: equal disks, mixtures, granular ones, other units, and larger ones.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene_makers.hpp"

namespace carom::test {
namespace {

/// What of a box walls leave is less: no lattice of this many disks fits at the packing fraction of a periodic box.
double least_packing(const Boundaries& boundary, double packing) {
  const bool periodic = boundary == Boundaries{Boundary::periodic, Boundary::periodic};
  return periodic ? packing : std::min(packing, 0.6);
}

Scene gas_in(const Boundaries& boundary, std::uint64_t count, double packing, std::uint64_t seed) {
  Scene scene = gas(count, packing, Boundary::periodic, seed);
  scene.boundary = boundary;
  if (packing <= 0.3) scene.gas[0].start = GasStart::random;
  return scene;
}

/// A kind of disk and how many of it.
struct Kind {
  std::uint64_t count;
  double radius;
  double mass;
};

/// Disks at random places in a square box, so large that they fill `packing` of it.
Scene mixture_of(const std::vector<Kind>& kinds, double packing, const Boundaries& boundary, std::uint64_t seed) {
  double covered = 0;
  for (const Kind& kind : kinds) covered += kPi * kind.radius * kind.radius * static_cast<double>(kind.count);
  const double width = std::sqrt(covered / packing);
  Scene scene = in_box({width, width}, boundary);
  for (const Kind& kind : kinds) scene.gas.push_back(some_disks(kind.count, kind.radius, kind.mass, seed));
  return scene;
}

/// Every disk its own radius and mass: radii over a decade, masses from 10⁻⁶ to 10⁶.
std::vector<Kind> all_different(std::uint64_t count, std::uint64_t seed) {
  RandomStream random = random_for(seed);
  std::vector<Kind> kinds;
  for (std::uint64_t k = 0; k < count; ++k) {
    double mass = 1e-6;
    for (std::uint64_t decade = random.below(13); decade > 0; --decade) mass *= 10;
    kinds.push_back({1, between(random, 0.2, 2), mass});
  }
  return kinds;
}

struct Mixture {
  const char* name;
  double packing;
  std::vector<Kind> kinds;
};

std::vector<Mixture> all_mixtures() {
  return {
      {"sizes 1:1.4", 0.45, {{40, 0.5, 1}, {30, 0.7, 2}}},
      {"sizes 1:10, one large", 0.35, {{1, 5, 100}, {80, 0.5, 1}}},
      {"sizes 1:100, three large", 0.3, {{3, 50, 1e4}, {60, 0.5, 1}}},
      {"masses 1:1e12", 0.3, {{25, 0.5, 1e-6}, {25, 0.5, 1e6}}},
      {"all different", 0.25, all_different(40, 5)},
  };
}

}  // namespace

void turn_inwards(Setup& setup) {
  const Box& box = setup.system.box;
  Frame& frame = setup.frame;
  for (std::size_t k = 0; k < frame.size(); ++k) {
    if (box.boundary[0] == Boundary::open) frame.vx[k] = std::copysign(frame.vx[k], box.size.x / 2 - frame.x[k]);
    if (box.boundary[1] == Boundary::open) frame.vy[k] = std::copysign(frame.vy[k], box.size.y / 2 - frame.y[k]);
  }
}

GeneratedScenes gases() {
  constexpr std::array kPackings{0.001, 0.01, 0.1, 0.3, 0.5, 0.7};
  constexpr std::array<std::uint64_t, 5> kDiluteCounts{2, 5, 13, 34, 89};
  constexpr std::array<std::uint64_t, 3> kDenseCounts{56, 90, 120};
  GeneratedScenes scenes;
  std::uint64_t seed = 0;
  for (const double wanted : kPackings) {
    for (const Boundaries& boundary : all_boundaries()) {
      ++seed;
      const double packing = least_packing(boundary, wanted);
      const bool open = boundary[0] == Boundary::open || boundary[1] == Boundary::open;
      const std::uint64_t least = open ? 13 : 2;
      const std::uint64_t count = packing > 0.3 ? kDenseCounts[seed % 3] : std::max(least, kDiluteCounts[seed / 2 % 5]);
      Setup setup = realize(gas_in(boundary, count, packing, seed));
      turn_inwards(setup);
      scenes.push_back({fmt::format("gas of {} disks, packing fraction {}, {}", count, packing, name_of(boundary)),
                        std::move(setup)});
    }
  }
  return scenes;
}

GeneratedScenes mixtures() {
  GeneratedScenes scenes;
  std::uint64_t seed = 300;
  for (const Mixture& mixture : all_mixtures()) {
    for (const Boundaries& boundary : all_boundaries()) {
      scenes.push_back({fmt::format("mixture, {}, {}", mixture.name, name_of(boundary)),
                        realize(mixture_of(mixture.kinds, mixture.packing, boundary, ++seed))});
    }
  }
  return scenes;
}

GeneratedScenes granular() {
  constexpr std::array kRestitutions{1.0, 0.9, 0.5, 0.1, 0.0};
  GeneratedScenes scenes;
  std::uint64_t seed = 400;
  for (const double restitution : kRestitutions) {
    for (const Boundaries& boundary : all_boundaries()) {
      ++seed;
      const double wall_restitution = restitution == 1 ? 0.9 : kRestitutions[seed % 5];
      Scene scene = gas_in(boundary, 20 + seed % 50, 0.2 + 0.1 * static_cast<double>(seed % 4), seed);
      scene.restitution = restitution;
      scene.wall_restitution = wall_restitution;
      if (seed % 4 == 0) scene.t_c = 0.01;  // long enough to make many contacts elastic
      scenes.push_back({fmt::format("granular gas, restitution {}, of walls {}, t_c {}, {}", restitution,
                                    wall_restitution, scene.t_c ? "0.01" : "default", name_of(boundary)),
                        realize(scene)});
    }
  }
  return scenes;
}

GeneratedScenes units() {
  struct Unit {
    double length, mass, temperature;
  };
  constexpr std::array kUnits{Unit{1e-9, 1e-26, 4e-21}, Unit{1e-30, 1, 1}, Unit{1e9, 1e30, 1e40},
                              Unit{1e30, 1e-30, 1e-20}, Unit{0.0571, 0.17, 3e-3}};
  GeneratedScenes scenes;
  std::uint64_t seed = 500;
  for (const Unit& unit : kUnits) {
    for (const Boundary boundary : {Boundary::periodic, Boundary::reflecting}) {
      Scene scene = gas(40, 0.4, boundary, ++seed);
      scene.gas[0].radius = unit.length;
      scene.gas[0].mass = unit.mass;
      scene.gas[0].temperature = unit.temperature;
      scenes.push_back({fmt::format("gas of radius {}, mass {}, kT {}, {}", unit.length, unit.mass, unit.temperature,
                                    carom::name_of(boundary)),
                        realize(scene)});
    }
  }
  return scenes;
}

GeneratedScenes large() {
  constexpr Boundaries kPeriodic{Boundary::periodic, Boundary::periodic};
  constexpr Boundaries kSlot{Boundary::periodic, Boundary::reflecting};
  constexpr Boundaries kClosed{Boundary::reflecting, Boundary::reflecting};
  constexpr Boundaries kOpen{Boundary::open, Boundary::open};
  RandomStream random = random_for(600);
  Scene dense = triangular_lattice({20, 20, 1.0324}, kPeriodic, [&](int, int) { return normal_velocity(random); });
  shuffle_ids(dense, random);
  return {
      {"500 disks, packing fraction 0.2, periodic", realize(gas_in(kPeriodic, 500, 0.2, 601))},
      {"500 disks, packing fraction 0.7, periodic", realize(gas_in(kPeriodic, 500, 0.7, 602))},
      {"400 disks, packing fraction 0.85, periodic", realize(dense)},
      {"300 disks between walls", realize(gas_in(kClosed, 300, 0.5, 603))},
      {"300 disks in a slot", realize(gas_in(kSlot, 300, 0.02, 604))},
      {"300 disks in the open", realize(gas_in(kOpen, 300, 0.5, 605))},
      {"300 disks, sizes 1:1.4, periodic", realize(mixture_of({{150, 0.5, 1}, {150, 0.7, 1.4}}, 0.45, kPeriodic, 606))},
  };
}

}  // namespace carom::test
