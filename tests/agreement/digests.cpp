// Same scene, same bits: prints for each scene the digest of its end state and the digest of its sequence of events,
// reached in two stretches. The output must equal digests.txt for every compiler and level of optimisation; both
// solvers, and the fast one with every instruction set and neighbourhood, must come to the same line.
//
// If a change is meant to change trajectories, write the new file by: carom_digests_O3 > tests/agreement/digests.txt
#include <fmt/format.h>

#include "carom/base/digest.hpp"
#include "carom/base/error.hpp"
#include "carom/run/simulation.hpp"
#include "carom/run/summary.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

class EventDigest final : public Observer {
 public:
  void on_window(const WindowRecord& window) override { add(window.collisions, window.before.clock.window); }

  void add(std::span<const Collision> collisions, std::uint64_t window) {
    for (const Collision& collision : collisions) {
      digest_.add(static_cast<std::int64_t>(window));
      for (const double value : {collision.time, collision.impulse, collision.point.x, collision.normal.y})
        digest_.add(value);
      for (const std::int64_t value :
           {std::int64_t{collision.generation}, std::int64_t{collision.i}, std::int64_t{collision.j},
            std::int64_t{collision.image.x}, std::int64_t{collision.image.y}}) {
        digest_.add(value);
      }
    }
  }

  [[nodiscard]] std::string hex() const { return digest_.hex(); }

 private:
  Digest digest_;
};

std::string digests_of(const Setup& setup, double until, const SolverOptions& options) {
  EventDigest events;
  Simulation simulation(setup, options);
  simulation.add_observer(events);
  simulation.run_until(0.37 * until);
  simulation.run_until(until);
  events.add(simulation.collisions_in_flight(), simulation.window_start().clock.window);
  const Summary summary = summarize(simulation);
  return fmt::format("{} {} {} {} {}", summary.digest, events.hex(), summary.collisions, summary.wall_collisions,
                     summary.ties);
}

/// Throws Error if the fast solver comes to other digests than `expected`.
void require_from_fast(const char* name, const Setup& setup, double until, const std::string& expected) {
  for (const Simd simd : available_simd()) {
    for (const Neighbourhood neighbourhood : {Neighbourhood::lists, Neighbourhood::cells}) {
      const std::string actual = digests_of(setup, until, {.simd = simd, .neighbourhood = neighbourhood});
      if (actual == expected) continue;
      throw Error(fmt::format("{}: reference {}, fast with {} and {} {}", name, expected, name_of(simd),
                              neighbourhood == Neighbourhood::lists ? "lists" : "cells", actual));
    }
  }
}

void print_digests(const char* name, const Scene& scene, double until) {
  const Setup setup = realize(scene);
  const std::string digests = digests_of(setup, until, {.kind = SolverKind::reference});
  require_from_fast(name, setup, until, digests);
  fmt::print("{:<24} {}\n", name, digests);
}

Scene with_restitution(Scene scene, double restitution) {
  scene.restitution = restitution;
  return scene;
}

Scene mixture() {
  Scene scene = test::gas(80, 0.15);
  GasSpec large = scene.gas[0];
  large.count = 20;
  large.packing_fraction = 0.15 * 20 * 4 / 80;
  large.radius = 1;
  large.mass = 10;
  scene.gas.push_back(large);
  return scene;
}

Scene random_start() {
  Scene scene = test::gas(100, 0.4, Boundary::periodic, 99);
  scene.gas[0].start = GasStart::random;
  return scene;
}

Scene tied_lattice() {
  Scene tied = test::box_of({12, 12}, Boundary::periodic, Boundary::periodic, {});
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      const double speed = 1 - column % 3;  // every third disk is hit from both sides at once
      tied.disks.push_back(test::disk({2.0 * column + 1, 2.0 * row + 1}, {speed, 0}));
    }
  }
  return tied;
}

void print_all() {
  using test::box_of;
  using test::disk;
  using test::gas;
  print_digests("gas 0.01", gas(50, 0.01), 400);
  print_digests("gas 0.30", gas(100, 0.3), 30);
  print_digests("gas 0.70", gas(100, 0.7), 6);
  print_digests("gas 0.86", gas(56, 0.86), 2);
  print_digests("gas between walls", gas(100, 0.5, Boundary::reflecting), 10);
  print_digests("gas in the open", gas(100, 0.5, Boundary::open), 30);
  Scene slot = gas(60, 0.4);
  slot.boundary = {Boundary::periodic, Boundary::reflecting};
  print_digests("gas in a slot", slot, 20);
  print_digests("mixture", mixture(), 15);
  print_digests("random start", random_start(), 20);
  print_digests("granular gas", with_restitution(gas(100, 0.3), 0.8), 60);
  print_digests("sticky gas", with_restitution(gas(40, 0.4), 0.0), 10);
  print_digests("two in a small box",
                box_of({2.2, 2.2}, Boundary::periodic, Boundary::periodic,
                       {disk({0.3, 0.7}, {0.31, 0.95}), disk({1.6, 1.6}, {-0.3, -1})}),
                500);
  print_digests("tied lattice", tied_lattice(), 20);
  print_digests("wall and two masses",
                box_of({20, 2}, Boundary::reflecting, Boundary::open,
                       {disk({1.5, 1}, {0, 0}), disk({3.5, 1}, {-1, 0}, 0.5, 1e6)}),
                16);
}

}  // namespace
}  // namespace carom

int main() {
  try {
    carom::print_all();
  } catch (const carom::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
