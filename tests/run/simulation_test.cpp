// A run depends on its scene alone: not on where it was stopped, probed, interrupted or observed.
#include "carom/run/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "carom/base/error.hpp"
#include "carom/run/exhaustion.hpp"
#include "carom/run/summary.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::box_of;
using test::disk;
using test::gas;

std::string digest_at(Simulation& simulation, double time) {
  simulation.run_until(time);
  return summarize(simulation).digest;
}

class CountingObserver : public Observer {
 public:
  void on_window(const WindowRecord& window) override {
    EXPECT_EQ(window.before.clock.start + window.before.clock.length, window.after.clock.start);
    EXPECT_TRUE(std::is_sorted(window.collisions.begin(), window.collisions.end(), stands_before));
    windows += 1;
    collisions += window.collisions.size();
  }
  std::uint64_t windows = 0;
  std::uint64_t collisions = 0;
};

TEST(Simulation, StoppingOnTheWayChangesNothing) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::reflecting, Boundary::open}) {
    Simulation straight(realize(gas(60, 0.6, boundary)));
    Simulation stopped(realize(gas(60, 0.6, boundary)));
    for (const double time : {0.1, 0.1, 0.25, 1.0, 1.7, 3.3, 5.0}) stopped.run_until(time);
    EXPECT_EQ(digest_at(stopped, 7.3), digest_at(straight, 7.3));
    EXPECT_EQ(stopped.books().collisions, straight.books().collisions);
    EXPECT_EQ(stopped.books().virial_of, straight.books().virial_of);
  }
}

TEST(Simulation, ObserversAndProbesChangeNothing) {
  CountingObserver observer;
  Simulation plain(realize(gas(60, 0.7)));
  Simulation observed(realize(gas(60, 0.7)));
  observed.add_observer(observer);
  for (int k = 1; k <= 400; ++k) {
    observed.run_until(0.01 * k);
    (void)observed.frame();
  }
  EXPECT_EQ(digest_at(observed, 4), digest_at(plain, 4));
  EXPECT_EQ(observer.collisions + observed.collisions_in_flight().size(), observed.books().events());
  EXPECT_EQ(observer.windows, observed.window_start().clock.window);
}

TEST(Simulation, AProbeShowsTheFlightBetweenEvents) {
  Simulation simulation(realize(box_of({10, 10}, Boundary::periodic, Boundary::periodic, {disk({9, 5}, {2, 0.5})})));
  simulation.run_until(0.75);
  const Frame frame = simulation.frame();
  EXPECT_EQ(frame.time, 0.75);
  EXPECT_EQ(frame.position(0), (Vec2{0.5, 5.375}));
  EXPECT_EQ(frame.winding_x[0], 1);
}

TEST(Simulation, TheStateAtAnEventsTimeIsTheOneBeforeIt) {
  Simulation simulation(realize(box_of({4, 4}, Boundary::reflecting, Boundary::reflecting, {disk({2, 2}, {1, 0})})));
  simulation.run_until(1.5);
  EXPECT_EQ(simulation.frame().velocity(0), (Vec2{1, 0}));
  EXPECT_EQ(simulation.books().wall_collisions, 0U);
  simulation.run_until(1.5 + 1e-9);
  EXPECT_EQ(simulation.frame().velocity(0), (Vec2{-1, 0}));
}

TEST(Simulation, AnInterruptedWindowIsAsIfNeverBegun) {
  std::atomic<bool> interrupt{false};
  Simulation simulation(realize(gas(60, 0.6)));
  simulation.stop_when(interrupt);
  simulation.run_until(1.9);
  interrupt = true;
  EXPECT_EQ(simulation.run_until(50), Simulation::Stop::interrupted);
  EXPECT_EQ(simulation.time(), simulation.window_start().clock.start);
  interrupt = false;
  Simulation straight(realize(gas(60, 0.6)));
  EXPECT_EQ(digest_at(simulation, 9), digest_at(straight, 9));
  EXPECT_EQ(simulation.books().events_of, straight.books().events_of);
}

static_assert(!std::is_copy_constructible_v<Simulation> && !std::is_move_constructible_v<Simulation>,
              "its solver refers to its system and its books");

TEST(Simulation, AnObserverAddedInTheMiddleStartsWithTheNextWindow) {
  CountingObserver observer;
  Simulation simulation(realize(gas(60, 0.6)));
  simulation.run_until(0.9 * simulation.window_start().clock.length);
  simulation.add_observer(observer);
  simulation.run_window();
  EXPECT_EQ(observer.windows, 0U);
  const std::uint64_t before = simulation.books().events();
  simulation.run_window();
  EXPECT_EQ(observer.windows, 1U);
  EXPECT_EQ(observer.collisions, simulation.books().events() - before);
}

TEST(Simulation, AFrameOfOneRunStartsAnotherAtTimeZero) {
  Simulation first(realize(gas(20, 0.2)));
  first.run_until(30);
  const Simulation second(carom::Setup{first.system(), first.frame()});
  const Frame frame = second.frame();
  EXPECT_EQ(frame.time, 0);
  EXPECT_EQ(frame.winding_x, std::vector<std::int64_t>(20, 0));
  EXPECT_EQ(frame.winding_y, std::vector<std::int64_t>(20, 0));
  EXPECT_EQ(frame.x, first.frame().x);
}

TEST(Simulation, RefusesArraysOfDifferentLengths) {
  carom::Setup setup = realize(gas(4, 0.1));
  setup.frame.vy.pop_back();
  EXPECT_THROW(Simulation{setup}, Error);
}

TEST(Simulation, SeesTheFastestDiskInTheSmallestBox) {
  // The shortest windows must be short enough for this, or images could not be numbered.
  Simulation simulation(
      realize(box_of({1e-10, 1e-10}, Boundary::periodic, Boundary::periodic,
                     {disk({2e-11, 2e-11}, {1e75, 0.3e75}, 1e-11), disk({7e-11, 7e-11}, {0, 0}, 1e-11)})));
  for (int k = 0; k < 20; ++k) simulation.run_window();
  EXPECT_GT(simulation.books().collisions, 0U);
  EXPECT_LT(simulation.books().largest_overlap, 1e-9);
}

TEST(Simulation, RefusesThePast) {
  Simulation simulation(realize(gas(4, 0.1)));
  simulation.run_until(3);
  EXPECT_THROW(simulation.run_until(2), Error);
  EXPECT_THROW(simulation.run_until(std::nan("")), Error);
  EXPECT_THROW(simulation.run_until(INFINITY), Error);
  EXPECT_THROW(simulation.run_until(1.1 * kLatestTime), Error);
  EXPECT_EQ(simulation.time(), 3);
}

TEST(Simulation, RefusesOverlappingDisks) {
  carom::Setup setup = realize(gas(4, 0.1));
  setup.frame.x[1] = setup.frame.x[0];
  setup.frame.y[1] = setup.frame.y[0];
  EXPECT_THROW(Simulation{setup}, Error);
}

TEST(Simulation, OneDiskAndRestingDisksRun) {
  Simulation one(realize(gas(1, 0.1)));
  one.run_until(100);
  EXPECT_EQ(one.books().events(), 0U);
  Simulation resting(
      realize(box_of({9, 9}, Boundary::periodic, Boundary::periodic, {disk({2, 2}, {0, 0}), disk({5, 5}, {0, 0})})));
  resting.run_until(1e6);
  EXPECT_EQ(resting.frame().position(1), (Vec2{5, 5}));
  EXPECT_TRUE(collisions_are_over(resting.system(), resting.frame()));
}

TEST(Simulation, ReachesTheLatestTimeInFewWindows) {
  Simulation simulation(
      realize(box_of({9, 9}, Boundary::open, Boundary::open, {disk({2, 2}, {1, 0}), disk({5, 2}, {-1, 0})})));
  simulation.run_until(kLatestTime);
  EXPECT_EQ(simulation.books().collisions, 1U);
  EXPECT_LT(simulation.windows(), 1000U);
}

TEST(Summary, MeasuresFromEquilibrationOn) {
  Simulation simulation(realize(gas(60, 0.5)));
  simulation.measure_from(3);
  simulation.run_until(2);
  EXPECT_FALSE(summarize(simulation).pressure);
  simulation.run_until(20);
  ASSERT_TRUE(simulation.measured().started);
  EXPECT_GE(simulation.measured().start, 3);
  EXPECT_NEAR(*summarize(simulation).pressure, 4.1 * 0.5 * 4 / kPi, 0.5);
}

TEST(Summary, TemperatureCountsDegreesOfFreedom) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::reflecting}) {
    const Simulation simulation(realize(gas(10, 0.3, boundary)));
    EXPECT_NEAR(*summarize(simulation).temperature, 1, 1e-14);
  }
  const Simulation one(realize(gas(1, 0.1)));
  EXPECT_FALSE(summarize(one).temperature);
}

TEST(Summary, CertificateSeesWhatIsWrong) {
  Summary summary;
  summary.energy_drift = 1e-13;
  EXPECT_TRUE(violations(summary).empty());
  summary.energy_drift = -1e-11;
  EXPECT_EQ(violations(summary).size(), 1U);
  summary.busiest_disk_events = 1'000'000;
  EXPECT_TRUE(violations(summary).empty());
  summary.max_overlap = 2e-9;
  EXPECT_EQ(violations(summary).size(), 1U);
  summary.elastic = false;
  summary.energy_drift = -0.5;
  EXPECT_EQ(violations(summary).size(), 1U);
}

TEST(Exhaustion, KnowsWhenDisksPart) {
  const auto over = [](const Scene& scene) {
    const carom::Setup setup = realize(scene);
    return collisions_are_over(setup.system, setup.frame);
  };
  EXPECT_TRUE(over(box_of({9, 9}, Boundary::open, Boundary::open, {disk({2, 2}, {-1, 0}), disk({5, 2}, {1, 0})})));
  EXPECT_FALSE(over(box_of({9, 9}, Boundary::open, Boundary::open, {disk({2, 2}, {1, 0}), disk({5, 2}, {-1, 0})})));
  EXPECT_TRUE(over(box_of({9, 9}, Boundary::periodic, Boundary::open, {disk({2, 2}, {1, -1}), disk({5, 5}, {-1, 1})})));
  EXPECT_FALSE(
      over(box_of({9, 9}, Boundary::periodic, Boundary::open, {disk({2, 2}, {1, 1}), disk({5, 5}, {-1, -1})})));
  EXPECT_FALSE(over(gas(5, 0.2)));
}

}  // namespace
}  // namespace carom
