// Energy and momentum are kept to rounding, runs can be reversed, and inelastic collisions lose energy only.
#include <gtest/gtest.h>

#include <cmath>

#include "carom/run/simulation.hpp"
#include "carom/run/summary.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::gas;

TEST(Conservation, HoldsOverAMillionCollisions) {
  Simulation simulation(realize(gas(16, 0.5)));
  while (simulation.books().collisions < 1'000'000) simulation.run_window();
  const Summary summary = summarize(simulation);
  EXPECT_LT(std::abs(summary.energy_drift), 1e-12);
  EXPECT_LT(*summary.momentum_drift, 1e-12);
  EXPECT_LT(summary.max_overlap, 1e-12);
  EXPECT_TRUE(violations(summary).empty());
}

TEST(Conservation, HoldsForMassesFromAMillionthToAMillion) {
  Scene scene = gas(60, 0.3);
  for (int k = 0; k < 6; ++k) {
    GasSpec gas = scene.gas[0];
    gas.count = 10;
    gas.packing_fraction = 0.05;
    gas.mass = std::pow(10.0, -6 + 2.4 * k);
    scene.gas.push_back(gas);
  }
  scene.gas.erase(scene.gas.begin());
  Simulation simulation(realize(scene));
  while (simulation.books().collisions < 20'000) simulation.run_window();
  const Summary summary = summarize(simulation);
  EXPECT_LT(std::abs(summary.energy_drift), 1e-12);
  EXPECT_LT(*summary.momentum_drift, 1e-12);
}

TEST(Conservation, MomentumAlongASlotBetweenWalls) {
  Scene scene = gas(30, 0.3);
  scene.boundary = {Boundary::periodic, Boundary::reflecting};
  Simulation simulation(realize(scene));
  simulation.run_until(50);
  EXPECT_GT(simulation.books().wall_collisions, 100U);
  EXPECT_LT(*summarize(simulation).momentum_drift, 1e-13);
  scene.boundary = {Boundary::reflecting, Boundary::reflecting};
  EXPECT_FALSE(summarize(Simulation(realize(scene))).momentum_drift);
}

TEST(Conservation, InelasticCollisionsKeepMomentumAndLoseEnergy) {
  Scene scene = gas(40, 0.4);
  scene.restitution = 0.9;
  Simulation simulation(realize(scene));
  double energy = simulation.initial().energy;
  for (int k = 1; k <= 20; ++k) {
    simulation.run_until(k);
    const double now = kinetic_energy(simulation.system(), simulation.frame());
    EXPECT_LT(now, energy);
    energy = now;
  }
  EXPECT_LT(*summarize(simulation).momentum_drift, 1e-13);
}

TEST(Reversal, BringsAGasBack) {
  const carom::Setup setup = realize(gas(40, 0.3));
  Simulation there(setup);
  there.run_until(2);
  ASSERT_GT(there.books().collisions, 30U);
  carom::Setup reversed{setup.system, there.frame()};
  reversed.frame.time = 0;
  for (std::size_t k = 0; k < reversed.frame.size(); ++k) {
    reversed.frame.vx[k] = -reversed.frame.vx[k];
    reversed.frame.vy[k] = -reversed.frame.vy[k];
  }
  Simulation back(reversed);
  back.run_until(2);
  const Frame frame = back.frame();
  for (std::size_t k = 0; k < frame.size(); ++k) {
    EXPECT_NEAR(frame.x[k], setup.frame.x[k], 1e-7);  // rounding grows by each collision's curvature
    EXPECT_NEAR(frame.vy[k], -setup.frame.vy[k], 1e-7);
  }
}

TEST(Galileo, AMovingGasDoesTheSame) {
  // With dyadic numbers the shifted run differs by rounding only; over a short time both count the same collisions.
  Scene scene = gas(30, 0.4);
  carom::Setup moving = realize(scene);
  for (double& vx : moving.frame.vx) vx += 0.25;
  Simulation rest(realize(scene));
  Simulation shifted(moving);
  rest.run_until(1);
  shifted.run_until(1);
  EXPECT_EQ(rest.books().collisions, shifted.books().collisions);
  const Frame a = rest.frame();
  const Frame b = shifted.frame();
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(b.vx[k] - 0.25, a.vx[k], 1e-10);
  EXPECT_NEAR(*summarize(shifted).temperature, *summarize(rest).temperature, 1e-12);
}

}  // namespace
}  // namespace carom
