// Speeds of a gas are Maxwell's, and speeds that are not are found out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "carom/base/random.hpp"
#include "observe/kolmogorov.hpp"
#include "observed.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::column;
using test::estimate;
using test::gas;
using test::observe;

TEST(Speeds, OfAGasAreMaxwells) {
  const auto set = observe(gas(200, 0.3), {{.name = "speeds"}}, {.from = 5, .collisions = 150'000});
  EXPECT_GT(estimate(*set, "speeds", "ks_p_value").value, 0.001);
  const Estimate ratio = estimate(*set, "speeds", "moment_ratio");
  EXPECT_DOUBLE_EQ(*ratio.theory, 2 * 199.0 / 200);  // ⟨v⁴⟩/⟨v²⟩² = 2(N−1)/N
  EXPECT_NEAR(ratio.value, *ratio.theory, 4 * *ratio.error);
  EXPECT_LT(*ratio.error, 0.02);
  const Table table = test::table(*set, "speeds", "speeds");
  double sum = 0;
  for (std::size_t bin = 0; bin < column(table, "speed").size(); ++bin) {
    sum += 0.1 * column(table, "f")[bin];
    const double c = column(table, "speed")[bin];
    EXPECT_NEAR(column(table, "f_theory")[bin], c * std::exp(-c * c / 2), 1e-3);
    EXPECT_NEAR(column(table, "f")[bin], column(table, "f_theory")[bin], 0.05);
  }
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(Speeds, OfTwoMassesAreMaxwellsEachAtTheSameTemperature) {
  Scene scene = gas(100, 0.15);
  scene.gas.push_back(scene.gas.front());
  scene.gas.back().mass = 7;
  const auto set = observe(scene, {{.name = "speeds"}}, {.from = 10, .collisions = 100'000});
  EXPECT_GT(estimate(*set, "speeds", "ks_p_value").value, 0.001);
  const Table table = test::table(*set, "speeds", "speeds");
  for (const char* name : {"f_1", "f_2"}) {
    double squares = 0;
    for (std::size_t bin = 0; bin < column(table, "speed").size(); ++bin) {
      squares += 0.1 * column(table, name)[bin] * column(table, "speed")[bin] * column(table, "speed")[bin];
    }
    EXPECT_NEAR(squares, 2, 0.05) << name;  // ⟨m v²/kT⟩
  }
}

/// A saved frame with these speeds, in directions that add up to no drift.
std::unique_ptr<ObservableSet> of_speeds(const std::vector<double>& speeds) {
  Scene scene = gas(speeds.size(), 0.1);
  carom::Setup setup = realize(scene);
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const double angle =
        2 * kPi * static_cast<double>(k / 2) / static_cast<double>(speeds.size() / 2) + (k % 2 == 0 ? 0 : kPi);
    setup.frame.vx[k] = speeds[k] * std::cos(angle);
    setup.frame.vy[k] = speeds[k] * std::sin(angle);
  }
  auto set = std::make_unique<ObservableSet>(std::vector<ObserveSpec>{{.name = "speeds"}},
                                             Subject{setup.system, setup.frame, 1.0});
  set->on_frame(setup.system, setup.frame);
  return set;
}

TEST(Speeds, ThatAreAllEqualAreNotMaxwells) {
  const auto set = of_speeds(std::vector<double>(400, 1.7));
  EXPECT_LT(estimate(*set, "speeds", "ks_p_value").value, 1e-6);
  // All in one place: the distance is that of the distribution function there, 1 − 1/e.
  EXPECT_NEAR(estimate(*set, "speeds", "ks_distance").value, 1 - std::exp(-1), 0.01);
  EXPECT_NEAR(estimate(*set, "speeds", "moment_ratio").value, 1, 1e-12);
  // H = ln(1/(area of a bin)) − 0: one bin of area 2π/4.
  EXPECT_NEAR(column(test::table(*set, "speeds", "boltzmann_h"), "H")[0], -std::log(kPi / 2), 1e-12);
}

TEST(Speeds, DistanceIsThatOfADirectComputation) {
  std::vector<double> speeds;
  RandomStream random(5, 0, 1);
  for (int k = 0; k < 200; ++k) {
    const double speed = std::hypot(random.normal(), random.normal());
    speeds.push_back(speed);
    speeds.push_back(speed);  // one each way
  }
  const auto set = of_speeds(speeds);
  double squares = 0;
  for (const double v : speeds) squares += v * v;
  const double kT = squares / 798;
  std::sort(speeds.begin(), speeds.end());
  double distance = 0;
  for (std::size_t k = 0; k < 400; ++k) {
    const double c2 = speeds[k] * speeds[k] / kT;
    const double expected = 1 - std::pow(1 - c2 / 797, 398);  // (1 − 1/N) f = 797.0…
    distance = std::max({distance, std::abs(static_cast<double>(k + 1) / 400 - expected),
                         std::abs(static_cast<double>(k) / 400 - expected)});
  }
  EXPECT_NEAR(estimate(*set, "speeds", "ks_distance").value, distance, 2e-3);
}

TEST(Kolmogorov, PValuesOfExponentialSamplesAreUniform) {
  constexpr int kRuns = 600;
  constexpr int kSamples = 400;
  int below_half = 0;
  int below_tenth = 0;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    RandomStream random(11, run, 3);
    std::vector<double> values(kSamples);
    double mean = 0;
    for (double& value : values) mean += (value = -std::log1p(-random.uniform())) / kSamples;
    std::sort(values.begin(), values.end());
    double distance = 0;
    for (int k = 0; k < kSamples; ++k) {
      const double expected = -std::expm1(-values[static_cast<std::size_t>(k)] / mean);
      distance = std::max({distance, (k + 1.0) / kSamples - expected, expected - k / static_cast<double>(kSamples)});
    }
    const double p = p_value_of_exponential(distance, kSamples);
    below_half += p < 0.5;
    below_tenth += p < 0.1;
  }
  EXPECT_NEAR(below_half / static_cast<double>(kRuns), 0.5, 0.08);
  EXPECT_NEAR(below_tenth / static_cast<double>(kRuns), 0.1, 0.04);
}

// Stephens, J. Am. Stat. Assoc. 69, 730 (1974), table 1A, case of the exponential distribution.
TEST(Kolmogorov, CriticalValuesAreThoseOfTheLiterature) {
  const double n = 1e8;
  for (const auto& [x, p] : {std::pair{0.926, 0.15}, {0.990, 0.1}, {1.094, 0.05}, {1.190, 0.025}, {1.308, 0.01}}) {
    EXPECT_NEAR(p_value_of_exponential(x / std::sqrt(n), n) / p, 1, 0.3) << x;
  }
  EXPECT_EQ(p_value_of_exponential(0, n), 1);
}

TEST(Speeds, BoltzmannsHFallsFromAnyStart) {
  Scene scene;
  scene.size = Vec2{40, 40};
  scene.boundary = {Boundary::periodic, Boundary::periodic};
  for (int k = 0; k < 400; ++k) {
    const double angle = k * 2.399963;
    scene.disks.push_back(test::disk({1 + 2.0 * (k % 20), 1 + 2.0 * (k / 20)}, {std::cos(angle), std::sin(angle)}));
  }
  const auto set = observe(scene, {{.name = "speeds", .options = {{"interval", 0.1}}}}, {.collisions = 4000});
  const Table table = test::table(*set, "speeds", "boltzmann_h");
  const std::vector<double>& h = column(table, "H");
  const double theory = column(table, "H_theory")[0];
  EXPECT_NEAR(theory, -(1 + std::log(2 * kPi)), 5e-3);
  EXPECT_GT(h.front(), theory + 1);
  EXPECT_NEAR(h.back(), theory, 0.1);
}

}  // namespace
}  // namespace carom
