// A gas has the pressure, the collision rate and the cooling that theory and the literature give it.
#include <gtest/gtest.h>

#include <cmath>

#include "carom/run/simulation.hpp"
#include "carom/run/summary.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::gas;

// Z = βP/ρ of the infinite system: Kolafa and Rottner, Mol. Phys. 104, 3435 (2006). For N = 100 the finite size and
// some 10⁵ collisions leave about 1 %.
TEST(Gas, HasThePressureOfTheEquationOfState) {
  for (const auto& [packing, expected] : {std::pair{0.1, 1.23614}, {0.3, 2.06326}, {0.5, 4.10636}}) {
    Simulation simulation(realize(gas(100, packing)));
    simulation.measure_from(20);
    while (simulation.books().collisions < 200'000) simulation.run_window();
    const double z = *summarize(simulation).pressure / (packing * 4 / kPi);
    EXPECT_NEAR(z / expected, 1, 0.015) << packing;
  }
}

// Γ d √(m/kT) of the same source; with f = 2N − 2 the finite-N factor is within 1 % of 1 at N = 100.
TEST(Gas, CollidesAtEnskogsRate) {
  for (const auto& [packing, expected] : {std::pair{0.1, 0.53292}, {0.3, 2.39952}, {0.5, 7.01031}}) {
    Simulation simulation(realize(gas(100, packing)));
    while (simulation.books().collisions < 200'000) simulation.run_window();
    const double rate = 2 * static_cast<double>(simulation.books().collisions) / 100 / simulation.time();
    EXPECT_NEAR(rate / expected, 1, 0.025) << packing;
  }
}

// Pressure on the walls of a large enough box approaches the virial one.
TEST(Gas, PressesOnItsWalls) {
  Simulation simulation(realize(gas(400, 0.05, Boundary::reflecting)));
  while (simulation.books().collisions < 60'000) simulation.run_window();
  const double ideal = 0.05 * 4 / kPi;
  const double bulk = 1.108 * ideal;  // Z at 0.05 from the first virial coefficients
  EXPECT_NEAR(*summarize(simulation).pressure / bulk, 1, 0.06);
}

// Haff, J. Fluid Mech. 134, 401 (1983): T = T0/(1 + t/τ)², 1/τ = (1 − e²) Γ0/4, until clusters form.
TEST(Gas, CoolsByHaffsLaw) {
  Scene scene = gas(400, 0.1);
  Simulation mixed(realize(scene));
  mixed.run_until(40);  // away from the lattice
  carom::Setup setup{mixed.system(), mixed.frame()};
  setup.frame.time = 0;
  setup.system.physics.restitution = 0.95;
  Simulation simulation(setup);
  const double rate = 0.53292;
  const double tau = 4 / ((1 - 0.95 * 0.95) * rate);
  simulation.run_until(tau);
  EXPECT_NEAR(*summarize(simulation).temperature * 4, 1, 0.06);
}

}  // namespace
}  // namespace carom
