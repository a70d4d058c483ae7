// Property: positions fold into the box without losing a turn, sums over disks are those of mechanics, and a digest
// sees every bit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "carom/base/random.hpp"
#include "carom/state/scene.hpp"
#include "carom/state/state.hpp"
#include "make_system.hpp"

namespace carom {
namespace {

void expect_wrapped(double coordinate, double period, double folded, std::int64_t turns) {
  const Wrapped wrapped = wrap(coordinate, period);
  EXPECT_EQ(wrapped.coordinate, folded) << coordinate;
  EXPECT_FALSE(std::signbit(wrapped.coordinate)) << coordinate;
  EXPECT_EQ(wrapped.turns, turns) << coordinate;
}

TEST(Wrap, ByHand) {
  expect_wrapped(3, 10, 3, 0);
  expect_wrapped(13, 10, 3, 1);
  expect_wrapped(-3, 10, 7, -1);
  expect_wrapped(-13, 10, 7, -2);
}

TEST(Wrap, MultiplesOfThePeriodAreZero) {
  for (const int n : {-1000, -3, -1, 0, 1, 2, 7, 1000}) expect_wrapped(n * 0.75, 0.75, 0, n);
  expect_wrapped(-0.0, 10, 0, 0);
}

TEST(Wrap, WhatRoundsUpToThePeriodIsZero) {
  for (const double tiny : {-1e-17, -1e-300, -std::numeric_limits<double>::denorm_min()}) expect_wrapped(tiny, 1, 0, 0);
  expect_wrapped(std::nextafter(1.0, 0.0), 1, std::nextafter(1.0, 0.0), 0);
}

TEST(Wrap, LosesNothing) {
  RandomStream random(1, 0, 0);
  for (int k = 0; k < 200'000; ++k) {
    const double period = std::exp2(20 * random.uniform() - 10);
    const double coordinate = period * (20 * random.uniform() - 10);
    const Wrapped wrapped = wrap(coordinate, period);
    ASSERT_LT(wrapped.coordinate, period);
    ASSERT_GE(wrapped.coordinate, -0x1p-49 * period) << "below zero by rounding at most";
    ASSERT_NEAR(wrapped.coordinate + static_cast<double>(wrapped.turns) * period, coordinate, 0x1p-49 * period);
  }
}

TEST(Wrap, OfWhatIsInTheBoxChangesNothing) {
  RandomStream random(2, 0, 0);
  for (int k = 0; k < 100'000; ++k) {
    const double period = std::exp2(20 * random.uniform() - 10);
    const Wrapped once = wrap(period * (4 * random.uniform() - 2), period);
    if (once.coordinate < 0) continue;  // rounding can leave that; the next turn takes it off
    const Wrapped twice = wrap(once.coordinate, period);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(twice.coordinate), std::bit_cast<std::uint64_t>(once.coordinate));
    ASSERT_EQ(twice.turns, 0);
  }
}

// --- sums over disks --------------------------------------------------------------------------------------------

TestSystem two_disks(std::array<Boundary, 2> boundary) {
  return TestSystem({.size = {10, 10}, .boundary = boundary}, {{{1, 1}, 0.5, {3, 4}, 2}, {{5, 5}, 0.5, {-1, 2}, 4}});
}

TEST(Frame, EnergyAndMomentumByHand) {
  const TestSystem test = two_disks(kPeriodic);
  EXPECT_EQ(kinetic_energy(test.system, test.frame), 25 + 10);
  EXPECT_EQ(momentum(test.system, test.frame), (Vec2{2, 16}));
  EXPECT_DOUBLE_EQ(momentum_scale(test.system, test.frame), 10 + 4 * std::sqrt(5.0));
}

TEST(Frame, TemperatureIsRelativeToTheDriftOfConservedAxes) {
  // Mean velocity ⟨1/3, 8/3⟩; energy 35, of the drift ½·6·(1/9) = 1/3 along x and ½·6·(64/9) = 64/3 along y.
  const auto kT = [](std::array<Boundary, 2> boundary) {
    const TestSystem test = two_disks(boundary);
    return temperature(test.system, test.frame);
  };
  EXPECT_DOUBLE_EQ(kT(kReflecting), 2 * 35.0 / 4);
  EXPECT_DOUBLE_EQ(kT(kPeriodic), 2 * (35 - 1.0 / 3 - 64.0 / 3) / 2);
  EXPECT_DOUBLE_EQ(kT(kOpen), kT(kPeriodic));
  EXPECT_DOUBLE_EQ(kT(kMixed), 2 * (35 - 1.0 / 3) / 3);
}

TEST(Frame, OneDiskInAPeriodicBoxHasNoTemperature) {
  const TestSystem test({.size = {10, 10}, .boundary = kPeriodic}, {{{1, 1}, 0.5, {3, 4}}});
  EXPECT_TRUE(std::isnan(temperature(test.system, test.frame)));
}

// --- digests ----------------------------------------------------------------------------------------------------

TEST(FrameDigest, SeesEveryBitOfEveryNumber) {
  TestSystem test = two_disks(kPeriodic);
  Frame& frame = test.frame;
  std::set<std::string> digests{digest(frame)};
  const auto flip_each_bit = [&](auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    const Value original = value;
    for (int bit = 0; bit < 64; ++bit) {
      value = std::bit_cast<Value>(std::bit_cast<std::uint64_t>(original) ^ (std::uint64_t{1} << bit));
      EXPECT_TRUE(digests.insert(digest(frame)).second) << "bit " << bit;
    }
    value = original;
  };
  flip_each_bit(frame.time);
  for (auto* column : {&frame.x, &frame.y, &frame.vx, &frame.vy}) {
    for (double& value : *column) flip_each_bit(value);
  }
  for (auto* column : {&frame.winding_x, &frame.winding_y}) {
    for (std::int64_t& value : *column) flip_each_bit(value);
  }
  EXPECT_EQ(digests.size(), 1u + 64 * (1 + 2 * 6));
}

TEST(SystemDigest, SeesEverythingThatDecidesTheMotion) {
  const TestSystem original = two_disks(kPeriodic);
  std::set<std::string> digests{digest(original.system, original.frame)};
  const auto changed = [&](const std::function<void(TestSystem&)>& change) {
    TestSystem copy = original;
    change(copy);
    EXPECT_TRUE(digests.insert(digest(copy.system, copy.frame)).second);
  };
  changed([](TestSystem& t) { t.system.box.size.x += 1e-15 * 10; });
  changed([](TestSystem& t) { t.system.box.size.y += 1; });
  changed([](TestSystem& t) { t.system.box.boundary[0] = Boundary::open; });
  changed([](TestSystem& t) { t.system.box.boundary[1] = Boundary::open; });
  changed([](TestSystem& t) { t.system.physics.restitution = 0.5; });
  changed([](TestSystem& t) { t.system.physics.wall_restitution = 0.5; });
  changed([](TestSystem& t) { t.system.physics.t_c = 0.5; });
  changed([](TestSystem& t) { t.system.species[0].radius = 0.75; });
  changed([](TestSystem& t) { t.system.species[1].mass = 5; });
  changed([](TestSystem& t) { t.frame.x[0] = 2; });
  changed([](TestSystem& t) { std::swap(t.system.species_of[0], t.system.species_of[1]); });
}

// --- the first state --------------------------------------------------------------------------------------------

TEST(InitialState, FoldsPeriodicPositionsAndStartsAtWindowZero) {
  TestSystem test({.size = {10, 10}, .boundary = kMixed}, {{{10, 9.5}, 0.5, {1, 2}}, {{-1e-12, 3}}, {{4, 0.5}}});
  const State state = initial_state({test.system, test.frame});
  EXPECT_EQ(state.disks.x[0], 0) << "the seam is one place, not two";
  EXPECT_GT(state.disks.x[1], 9.99);
  EXPECT_EQ(state.disks.x[2], 4);
  EXPECT_EQ(state.disks.y[0], 9.5);
  EXPECT_EQ(state.disks.velocity(0), (Vec2{1, 2}));
  EXPECT_EQ(state.disks.winding_x, (std::vector<std::int64_t>{0, 0, 0}));
  EXPECT_EQ(state.disks.winding_y, (std::vector<std::int64_t>{0, 0, 0}));
  EXPECT_EQ(state.clock.window, 0u);
  EXPECT_EQ(state.clock.start, 0);
  EXPECT_TRUE(state.last_contact.empty()) << "elastic systems need none";
}

TEST(InitialState, RemembersNoContactWhereRestitutionMatters) {
  TestSystem test({.size = {10, 10}, .boundary = kReflecting}, {{{5, 5}}});
  test.system.physics.wall_restitution = 0.5;
  const State state = initial_state({test.system, test.frame});
  ASSERT_EQ(state.last_contact.size(), 1u);
  EXPECT_EQ(state.last_contact[0], -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace carom
