// Temperatures, profiles, walls and the pressure tensor are those of hand computations, and granular gases cool by
// Haff's law.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "observe/time_series.hpp"
#include "observed.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::column;
using test::estimate;
using test::gas;
using test::observe;

// Haff, J. Fluid Mech. 134, 401 (1983): T = T0/(1 + t/τ)², 1/τ = (1 − e²) Γ0/4. Corrections of higher order in the
// velocity distribution are about 1 % at e = 0.9.
TEST(Temperature, OfAGranularGasFallsByHaffsLaw) {
  Simulation mixed(realize(gas(2000, 0.1)));
  mixed.run_until(40);  // away from the lattice
  carom::Setup setup{mixed.system(), mixed.frame()};
  setup.frame.time = 0;
  setup.system.physics.restitution = 0.9;
  ObservableSet set({{.name = "temperature"}}, {setup.system, setup.frame});
  Simulation simulation(setup);
  simulation.add_observer(set);
  const double tau = 4 / ((1 - 0.9 * 0.9) * 0.53292);
  while (simulation.time() < 2 * tau) simulation.run_window();
  const Estimate rate = estimate(set, "temperature", "cooling_rate");
  EXPECT_NEAR(*rate.theory * tau, 1, 0.02);
  EXPECT_NEAR(rate.value / *rate.theory, 1, 0.05);
  EXPECT_NEAR(*rate.error / rate.value, 0.012, 0.002);  // some 15,000 collisions
  EXPECT_NEAR(estimate(set, "temperature", "initial_kT").value, 1, 0.05);
  const Table table = test::table(set, "temperature", "temperature");
  for (std::size_t row = 0; row < column(table, "time").size(); ++row) {
    if (column(table, "time")[row] > 2 * tau) break;
    EXPECT_NEAR(column(table, "kT")[row] / column(table, "kT_theory")[row], 1, 0.12);
  }
}

TEST(Temperature, OfAnElasticGasStays) {
  const auto set = observe(gas(50, 0.2), {{.name = "temperature"}}, {.collisions = 5000});
  const Estimate kT = estimate(*set, "temperature", "kT");
  EXPECT_NEAR(kT.value, 1, 1e-12);
  EXPECT_TRUE(kT.warnings.empty()) << "a constant needs no long run";
}

TEST(TimeSeries, IsThinnedOutEvenly) {
  TimeSeries series;
  constexpr int kValues = 5000;
  for (int k = 0; k < kValues; ++k) series.add(k, 2.0 * k);
  EXPECT_LE(series.times().size(), TimeSeries::kMostRows);
  EXPECT_GT(series.times().size(), TimeSeries::kMostRows / 2);
  for (std::size_t row = 0; row < series.times().size(); ++row) {
    EXPECT_EQ(series.times()[row], 8.0 * static_cast<double>(row));
    EXPECT_EQ(series.values()[row], 16.0 * static_cast<double>(row));
  }
}

TEST(Profile, IsThatOfStripsCountedByHand) {
  // Two disks in the left half with kT far from that of the two in the right one; in a closed box nothing is corrected.
  carom::Setup setup = realize(test::box_of({8, 4}, Boundary::reflecting, Boundary::reflecting,
                                            {test::disk({1, 1}, {1, 2}), test::disk({3, 3}, {0, 1}),
                                             test::disk({5, 1}, {3, 0}, 0.5, 2), test::disk({7, 3.5}, {0, 0})}));
  ObservableSet set({{.name = "temperature_profile", .options = {{"bins", 2}}}}, {setup.system, setup.frame, 1.0});
  set.on_frame(setup.system, setup.frame);
  const Table kT = test::table(set, "temperature_profile", "temperature_profile_x");
  EXPECT_EQ(column(kT, "x"), (std::vector<double>{2, 6}));
  EXPECT_EQ(column(kT, "kT"), (std::vector<double>{0.25 * (5 + 1), 0.25 * (2 * 9 + 0)}));
  const Table density = test::table(set, "temperature_profile", "density_profile_y");
  EXPECT_EQ(column(density, "density"), (std::vector<double>{2.0 / 16, 2.0 / 16}));
}

TEST(Profile, OfAGasIsFlat) {
  const auto set = observe(gas(100, 0.3), {{.name = "temperature_profile", .options = {{"bins", 4}}}},
                           {.from = 5, .collisions = 40'000});
  for (const char* axis : {"x", "y"}) {
    const Table table = test::table(*set, "temperature_profile", std::string("temperature_profile_") + axis);
    for (std::size_t bin = 0; bin < 4; ++bin) {
      EXPECT_NEAR(column(table, "kT")[bin], 1, 5 * column(table, "kT_error")[bin]);
      EXPECT_LT(column(table, "kT_error")[bin], 0.05);
    }
  }
}

TEST(Walls, FeelASingleDisk) {
  // It meets left and right every 2 (8 − 1)/2 with an impulse of 2 · 2, bottom and top every 2 (4 − 1)/0.5 with 2 ·
  // 0.5.
  const Scene scene = test::box_of({8, 4}, Boundary::reflecting, Boundary::reflecting, {test::disk({2, 2}, {2, 0.5})});
  const auto set = observe(scene, {{.name = "wall_pressure"}, {.name = "pressure"}}, {.windows = 4000});
  const double kT = 0.5 * (4 + 0.25);
  const double across = 4 / (2 * 7 / 2.0) / 4 / kT;
  const double along = 1 / (2 * 3 / 0.5) / 8 / kT;
  for (const auto& [wall, pressure] :
       {std::pair{"left", across}, {"right", across}, {"bottom", along}, {"top", along}}) {
    EXPECT_NEAR(estimate(*set, "wall_pressure", std::string("pressure_") + wall).value / pressure, 1, 0.01) << wall;
  }
  const double mean = (across * 4 + along * 8) / 12;
  EXPECT_NEAR(estimate(*set, "pressure", "pressure").value / mean, 1, 0.01);
}

TEST(Tensor, HasThePressureAsItsTraceAndNoShear) {
  const auto set =
      observe(gas(100, 0.4), {{.name = "pressure"}, {.name = "pressure_tensor"}}, {.from = 3, .collisions = 40'000});
  const double xx = estimate(*set, "pressure_tensor", "pressure_xx").value;
  const double yy = estimate(*set, "pressure_tensor", "pressure_yy").value;
  EXPECT_NEAR(0.5 * (xx + yy) / estimate(*set, "pressure", "pressure").value, 1, 1e-11);
  const Estimate xy = estimate(*set, "pressure_tensor", "pressure_xy");
  EXPECT_NEAR(xy.value, 0, 4 * *xy.error);
  EXPECT_NEAR(xx, yy, 6 * *estimate(*set, "pressure_tensor", "pressure_xx").error);
}

TEST(Tensor, OfDisksInARowIsAlongTheRow) {
  // Two disks on one line along x: they meet every (8 − 2)/4, the second time over the seam.
  const Scene scene = test::box_of({8, 3}, Boundary::periodic, Boundary::periodic,
                                   {test::disk({2, 1}, {2, 0}), test::disk({6, 1}, {-2, 0})});
  const auto set = observe(scene, {{.name = "pressure_tensor"}}, {.windows = 4000});
  const double kT = (4 + 4) / 2.0;
  const double carried = 2 * (4 + 4);
  const double handed = 4 * 1 / (6 / 4.0);
  EXPECT_NEAR(estimate(*set, "pressure_tensor", "pressure_xx").value / ((carried + handed) / (24 * kT)), 1, 0.01);
  EXPECT_EQ(estimate(*set, "pressure_tensor", "pressure_yy").value, 0);
  EXPECT_EQ(estimate(*set, "pressure_tensor", "pressure_xy").value, 0);
}

}  // namespace
}  // namespace carom
