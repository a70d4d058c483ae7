// The pressure is that of exact results and of the equation of state, and that of the run's summary.
#include <gtest/gtest.h>

#include <cmath>

#include "carom/observe/observable_set.hpp"
#include "carom/observe/theory.hpp"
#include "carom/run/summary.hpp"
#include "observed.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::estimate;
using test::observe;

TEST(Pressure, IsThatOfTheSummary) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::reflecting}) {
    Simulation simulation(realize(test::gas(50, 0.3, boundary)));
    ObservableSet set({{.name = "pressure"}}, {simulation.system(), simulation.frame()});
    simulation.measure_from(3);
    simulation.add_observer(set);
    for (int k = 0; k < 50; ++k) simulation.run_window();
    EXPECT_NEAR(estimate(set, "pressure", "pressure").value / *summarize(simulation).pressure, 1, 1e-12);
  }
}

// Exact: Z_ex = πd²/[2(L² − πd²)] for two disks of opposite velocities in a periodic square.
TEST(Pressure, OfTwoDisksIsExact) {
  const double length = 4;
  const Scene scene = test::box_of({length, length}, Boundary::periodic, Boundary::periodic,
                                   {test::disk({0.3, 0.4}, {1, 0.377}), test::disk({2.4, 1.3}, {-1, -0.377})});
  const auto set = observe(scene, {{.name = "pressure"}}, {.collisions = 100'000});
  const Estimate z = estimate(*set, "pressure", "Z");
  const double exact = 1 + kPi / (2 * (length * length - kPi));
  EXPECT_DOUBLE_EQ(*z.theory, exact);
  EXPECT_NEAR(z.value, exact, 4 * *z.error);
  EXPECT_LT(*z.error, 3e-3);
  EXPECT_GT(z.blocks, 0U);
}

TEST(Pressure, IsThatOfTheEquationOfState) {
  const auto set = observe(test::gas(400, 0.3), {{.name = "pressure"}}, {.from = 10, .collisions = 400'000});
  const Estimate z = estimate(*set, "pressure", "Z");
  EXPECT_NEAR(*z.theory, 2.06326 * (1 - 0.375 / 400), 1e-5);
  EXPECT_NEAR(z.value, *z.theory, 4 * *z.error);
  EXPECT_LT(*z.error, 0.01);
  const Estimate pressure = estimate(*set, "pressure", "pressure_d2");
  EXPECT_DOUBLE_EQ(pressure.value, z.value * 0.3 * 4 / kPi);
  EXPECT_DOUBLE_EQ(*pressure.error, *z.error * 0.3 * 4 / kPi);
}

// Table of Z in Kolafa and Rottner 2006, and the contact values that belong to it.
TEST(Theory, IsThatOfTheLiterature) {
  for (const auto& [eta, z] : {std::pair{.1, 1.23614},
                               {.2, 1.57037},
                               {.3, 2.06326},
                               {.4, 2.82933},
                               {.5, 4.10636},
                               {.6, 6.45534},
                               {.65, 8.40804},
                               {.67, 9.36246},
                               {.69, 10.2007}}) {
    EXPECT_NEAR(kolafa_rottner(eta) / z, 1, 3e-6) << eta;
  }
  const EqualDisks gas{.number_density = 0.5 * 4 / kPi, .packing_fraction = 0.5};
  EXPECT_NEAR(enskog_rate(gas, 1), 7.01031, 1e-5);
  // To the first order in the density N disks have N − 1 partners: Z − 1 = 2η (N − 1)/N.
  const EqualDisks dilute{.packing_fraction = 1e-6, .disks = 100};
  EXPECT_NEAR((finite_compressibility(dilute) - 1) / 2e-6, 0.99, 1e-5);
  EXPECT_DOUBLE_EQ(finite_compressibility({.packing_fraction = 0.66, .disks = 100}), kolafa_rottner(0.66));
  // Virial coefficients: Z = 1 + 2η + 0.782004 (2η)² + 0.5322318 (2η)³ + …
  EXPECT_NEAR(kolafa_rottner(1e-3), 1 + 2e-3 + 0.782004 * 4e-6 + 0.5322318 * 8e-9, 1e-11);
  // C = √(f/2) Γ(f/2)/Γ((f+1)/2): for f = 2 it is 2/√π, for large f 1 + 1/(4f).
  EXPECT_NEAR(finite_rate_factor(2), 2 / std::sqrt(kPi), 1e-14);
  EXPECT_NEAR(finite_rate_factor(2e4), 1 + 1 / (4 * 2e4), 1e-8);
}

TEST(Theory, IsForFluidsOfEqualDisksOnly) {
  const auto known = [](const Scene& scene) { return fluid_of_equal_disks(realize(scene).system).has_value(); };
  EXPECT_TRUE(known(test::gas(60, 0.5)));
  EXPECT_FALSE(known(test::gas(20, 0.5))) << "too few disks";
  EXPECT_FALSE(known(test::gas(60, 0.75)));
  EXPECT_FALSE(known(test::gas(60, 0.5, Boundary::reflecting)));
  Scene granular = test::gas(60, 0.5);
  granular.restitution = 0.9;
  EXPECT_FALSE(known(granular));
  Scene mixture = test::gas(60, 0.3);
  mixture.gas.push_back(mixture.gas.front());
  mixture.gas.back().mass = 2;
  EXPECT_FALSE(known(mixture));
}

}  // namespace
}  // namespace carom
