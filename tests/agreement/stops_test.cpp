// With the fast solver, what comes later does not depend on where a run was stopped, interrupted or looked at.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "carom/run/simulation.hpp"
#include "carom/run/summary.hpp"
#include "scenes.hpp"

namespace carom::test {
namespace {

using Options = std::vector<SolverOptions>;

const Options kAllWays{{.neighbourhood = Neighbourhood::lists}, {.neighbourhood = Neighbourhood::cells}};

Scene slot() {
  Scene scene = gas(90, 0.5, Boundary::periodic, 3);
  scene.boundary = {Boundary::periodic, Boundary::reflecting};
  return scene;
}

Scene granular() {
  Scene scene = gas(70, 0.3, Boundary::periodic, 4);
  scene.restitution = 0.9;
  return scene;
}

std::vector<Scene> scenes() { return {gas(80, 0.7), gas(40, 0.02), slot(), granular()}; }

/// The end state of a run with the reference solver that goes straight there.
std::string digest_at(const Scene& scene, double time) {
  Simulation simulation(realize(scene), {.kind = SolverKind::reference});
  simulation.run_until(time);
  return digest(simulation.frame());
}

/// Calls `go(simulation, end)` for every scene and way of searching, and compares the state in which it leaves the run.
template <typename Go>
void expect_reference_end(Go go) {
  for (const Scene& scene : scenes()) {
    const double end = 20.3 * Simulation(realize(scene)).window_start().clock.length;
    const std::string expected = digest_at(scene, end);
    for (const SolverOptions& options : kAllWays) {
      Simulation simulation(realize(scene), options);
      go(simulation, end);
      ASSERT_EQ(simulation.time(), end);
      EXPECT_EQ(digest(simulation.frame()), expected);
    }
  }
}

TEST(FastStops, StoppingOnTheWayChangesNothing) {
  expect_reference_end([](Simulation& simulation, double end) {
    for (const double share : {1e-9, 0.01, 0.01, 0.3, 0.31, 0.5, 0.77, 0.999999, 1.0})
      simulation.run_until(share * end);
  });
}

TEST(FastStops, ReadingFramesOftenChangesNothing) {
  expect_reference_end([](Simulation& simulation, double end) {
    constexpr int kFrames = 3000;
    for (int k = 1; k <= kFrames; ++k) {
      simulation.run_until(k == kFrames ? end : end * k / kFrames);
      ASSERT_EQ(simulation.frame().time, simulation.time());
    }
  });
}

TEST(FastStops, AWindowInterruptedInItsMiddleIsAsIfNeverBegun) {
  expect_reference_end([](Simulation& simulation, double end) {
    std::atomic<bool> interrupt{false};
    simulation.stop_when(interrupt);
    for (const double share : {0.001, 0.2, 0.2, 0.55, 0.9}) {
      simulation.run_until(share * end);
      interrupt = true;
      ASSERT_EQ(simulation.run_until(end), Simulation::Stop::interrupted);
      ASSERT_EQ(simulation.time(), simulation.window_start().clock.start);
      interrupt = false;
    }
    simulation.run_until(end);
  });
}

TEST(FastStops, InterruptsAtAnyMomentChangeNothing) {
  expect_reference_end([](Simulation& simulation, double end) {
    std::atomic<bool> interrupt{false};
    simulation.stop_when(interrupt);
    std::thread impatient([&] {
      for (int k = 0; k < 40; ++k) {
        std::this_thread::sleep_for(std::chrono::microseconds(50 * (k % 7)));
        interrupt = true;
      }
    });
    while (simulation.run_until(end) == Simulation::Stop::interrupted) interrupt = false;
    impatient.join();
  });
}

class KeepFirstWindow final : public Observer {
 public:
  void on_window(const WindowRecord& window) override {
    if (window.before.clock.window == 0) events.assign(window.collisions.begin(), window.collisions.end());
  }
  std::vector<Collision> events;
};

TEST(FastStops, AStopAtAnEventsTimeIsBeforeTheEvent) {
  for (const Scene& scene : scenes()) {
    KeepFirstWindow keeper;
    Simulation whole(realize(scene), {.kind = SolverKind::reference});
    whole.add_observer(keeper);
    whole.run_window();
    for (const SolverOptions& options : kAllWays) {
      Simulation reference(realize(scene), {.kind = SolverKind::reference});
      Simulation fast(realize(scene), options);
      for (const Collision& event : keeper.events) {
        for (const double time : {event.time, std::nextafter(event.time, 1e9)}) {
          if (time < fast.time()) continue;  // events at one time
          reference.run_until(time);
          fast.run_until(time);
          ASSERT_EQ(fast.books().events(), reference.books().events());
          ASSERT_EQ(digest(fast.frame()), digest(reference.frame()));
        }
      }
    }
  }
}

TEST(FastStops, ASolverForgetsTheWindowItHadBefore) {
  const carom::Setup here = realize(gas(80, 0.6));
  Simulation simulation(here, {.kind = SolverKind::reference});
  std::vector<State> starts{simulation.window_start()};
  for (int k = 0; k < 4; ++k) {
    simulation.run_window();
    starts.push_back(simulation.window_start());
  }
  const std::atomic<bool> never{false};
  for (const SolverOptions& options : kAllWays) {
    const auto solver = make_fast_solver(here.system, options);
    for (const std::size_t k : {2, 0, 3, 1, 1}) {  // backwards and forwards in time
      Books books(here.system.size());
      State next;
      solver->open(starts[k], books, nullptr);
      solver->advance_to(0.5 * starts[k].clock.length, never);
      solver->open(starts[k], books, nullptr);
      ASSERT_TRUE(solver->advance_to(starts[k].clock.length, never));
      solver->close(next);
      EXPECT_EQ(next.disks.x, starts[k + 1].disks.x);
      EXPECT_EQ(next.disks.vy, starts[k + 1].disks.vy);
      EXPECT_EQ(next.disks.winding_x, starts[k + 1].disks.winding_x);
    }
  }
}

}  // namespace
}  // namespace carom::test
