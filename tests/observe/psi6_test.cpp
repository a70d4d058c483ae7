// Property: Ψ6 is 1 in a triangular lattice and small in random points; g6(r) is what a loop over all pairs gives.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "carom/order/local_order.hpp"
#include "frames.hpp"

namespace carom {
namespace {

using test::column;
using test::estimate;
using test::make;
using test::measured;

TEST(Psi6, OfATriangularLatticeIsOne) {
  const Arrangement lattice = triangular_lattice(10, 6, 1);
  const Measurement found = measured("psi6", lattice);
  for (const char* name : {"psi6_global", "psi6_local", "sixfold"}) {
    EXPECT_NEAR(estimate(found, name).value, 1, 1e-12) << name;
  }
  EXPECT_EQ(estimate(found, "fivefold").value, 0);
  EXPECT_EQ(estimate(found, "sevenfold").value, 0);
  EXPECT_NEAR(estimate(found, "susceptibility").value, 0, 1e-9);
  for (const double g6 : column(found, "g6", "g6")) EXPECT_NEAR(g6, 1, 1e-12);
  EXPECT_NEAR(column(found, "psi6", "angle")[0], 0, 1e-12);
}

TEST(Psi6, CorrelationIsWhatALoopOverAllPairsGives) {
  const Arrangement points = random_points(200, {6, 5}, 3);
  const std::size_t bins = 25;
  const double range = 2.5;
  const LocalOrder order = local_order(points.system, points.frame);
  std::vector<double> sum(bins, 0);
  std::vector<double> count(bins, 0);
  for (std::size_t i = 0; i < 200; ++i) {
    for (std::size_t j = 0; j < 200; ++j) {
      const double r = length(test::nearest_image(points, i, j));
      if (i == j || r >= range) continue;
      const auto bin = static_cast<std::size_t>(r / range * bins);
      sum[bin] += std::real(std::conj(order.psi6[i]) * order.psi6[j]);
      ++count[bin];
    }
  }
  const Measurement found = measured("psi6", points, {{"r_max", range}, {"bins", bins}});
  const std::vector<double>& g6 = column(found, "g6", "g6");
  ASSERT_EQ(g6.size(), bins);
  for (std::size_t bin = 0; bin < bins; ++bin) EXPECT_NEAR(g6[bin], sum[bin] / count[bin], 1e-12);
}

TEST(Psi6, AveragesAreThoseOfTheFrames) {
  const auto psi6 = make("psi6", random_points(100, {6, 5}, 0));
  double sum = 0;
  double squares = 0;
  double local = 0;
  double sixfold = 0;
  const int frames = 64;
  for (int frame = 0; frame < frames; ++frame) {
    const Arrangement points = random_points(100, {6, 5}, static_cast<std::uint64_t>(frame));
    psi6->on_frame(points.system, points.frame);
    const LocalOrder order = local_order(points.system, points.frame);
    std::complex<double> mean = 0;
    for (std::size_t k = 0; k < 100; ++k) {
      mean += order.psi6[k] / 100.0;
      local += std::abs(order.psi6[k]) / 100 / frames;
      sixfold += (order.neighbours[k] == 6 ? 0.01 : 0) / frames;
    }
    sum += std::abs(mean) / frames;
    squares += std::norm(mean) / frames;
  }
  const Measurement found = psi6->result();
  EXPECT_NEAR(estimate(found, "psi6_global").value, sum, 1e-12);
  EXPECT_NEAR(estimate(found, "psi6_local").value, local, 1e-12);
  EXPECT_NEAR(estimate(found, "sixfold").value, sixfold, 1e-12);
  EXPECT_NEAR(estimate(found, "susceptibility").value, 100 * (squares - sum * sum), 1e-10);
  EXPECT_TRUE(estimate(found, "susceptibility").error.has_value());
  EXPECT_EQ(column(found, "psi6", "time").size(), 64U);
  EXPECT_LT(sum, 0.1);
}

TEST(Psi6, IsKnownBetweenWallsAndInTheOpen) {
  for (const auto& boundary : {kReflecting, kMixed, kOpen}) {
    const Measurement found = measured("psi6", random_points(50, {6, 5}, 4, boundary), {{"r_max", 2}});
    EXPECT_GT(estimate(found, "psi6_local").value, 0.1);
    EXPECT_LT(estimate(found, "psi6_local").value, 0.7);
  }
}

}  // namespace
}  // namespace carom
