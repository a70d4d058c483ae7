// Window lengths are powers of two chosen from the state alone, hold a few contacts per disk, and start exactly.
#include "carom/run/window_length.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "carom/run/simulation.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::box_of;
using test::disk;
using test::gas;

bool is_power_of_two(double value) {
  int exponent = 0;
  return std::frexp(value, &exponent) == 0.5;
}

TEST(WindowLength, HoldsAFewContactsPerDisk) {
  for (const double packing : {0.05, 0.2, 0.5, 0.7}) {
    Simulation simulation(realize(gas(400, packing)));
    for (int k = 0; k < 4; ++k) simulation.run_window();
    const double contacts = 2 * static_cast<double>(simulation.books().collisions) / 400 / 4;
    EXPECT_GT(contacts, contacts_per_window(simulation.system()) / 3) << packing;
    EXPECT_LT(contacts, contacts_per_window(simulation.system()) * 2) << packing;
  }
}

TEST(WindowLength, IsAPowerOfTwoAndStartsAreItsMultiples) {
  Scene scene = gas(50, 0.4);
  scene.restitution = 0.8;  // cools down, so that windows grow
  Simulation simulation(realize(scene));
  double longest = 0;
  for (int k = 0; k < 300; ++k) {
    simulation.run_window();
    const Clock& clock = simulation.window_start().clock;
    ASSERT_TRUE(is_power_of_two(clock.length));
    ASSERT_EQ(std::fmod(clock.start, clock.length), 0);
    longest = std::max(longest, clock.length);
  }
  EXPECT_GE(longest, 4 * first_window_length(simulation.system(), initial_state(realize(scene))));
}

TEST(WindowLength, DoesNotLetADiskCrossThePeriodicBoxTooOften) {
  const carom::Setup setup =
      realize(box_of({10, 1000}, Boundary::periodic, Boundary::periodic, {disk({5, 5}, {40, 0}, 0.01)}));
  EXPECT_LE(first_window_length(setup.system, initial_state(setup)), 8 * 10.0 / 40);
}

TEST(WindowLength, IsOneWhereNothingMoves) {
  const carom::Setup setup = realize(box_of({9, 9}, Boundary::open, Boundary::open, {disk({5, 5}, {0, 0})}));
  EXPECT_EQ(first_window_length(setup.system, initial_state(setup)), 1);
}

TEST(WindowLength, DoesNotDependOnWhereARunIsStopped) {
  Simulation straight(realize(gas(50, 0.4)));
  Simulation stopped(realize(gas(50, 0.4)));
  straight.run_until(20);
  for (int k = 1; k <= 57; ++k) stopped.run_until(20.0 * k / 57);
  stopped.run_until(20);
  EXPECT_EQ(straight.window_start().clock.window, stopped.window_start().clock.window);
  EXPECT_EQ(straight.window_start().clock.length, stopped.window_start().clock.length);
}

}  // namespace
}  // namespace carom
