// Ten million collisions leave no trace of rounding: no overlap, no drift of energy or momentum.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "carom/run/summary.hpp"
#include "scenes.hpp"

namespace carom::test {
namespace {

class LongRun : public testing::TestWithParam<double> {};

TEST_P(LongRun, KeepsDisksApartAndEnergyAndMomentum) {
  Simulation simulation(realize(gas(1000, GetParam())));
  while (simulation.books().collisions < 10'000'000) simulation.run_window();
  const Summary summary = summarize(simulation);
  fmt::print("overlap {:.3g}, energy drift {:.3g}, momentum drift {:.3g}, ties {}\n", summary.max_overlap,
             summary.energy_drift, *summary.momentum_drift, summary.ties);
  EXPECT_TRUE(violations(summary).empty());
  EXPECT_LT(summary.max_overlap, 1e-9);
  EXPECT_LT(std::abs(summary.energy_drift), 1e-12);
  EXPECT_LT(*summary.momentum_drift, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(AtPacking, LongRun, testing::Values(0.2, 0.7),
                         [](const auto& packing) { return packing.param < 0.5 ? "dilute" : "dense"; });

}  // namespace
}  // namespace carom::test
