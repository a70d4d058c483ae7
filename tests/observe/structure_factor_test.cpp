// Property: S(k) is 1 for an ideal gas, N at the Bragg peaks of a lattice and 0 between them.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "carom/base/error.hpp"
#include "frames.hpp"

namespace carom {
namespace {

using test::column;
using test::make;
using test::measured;

TEST(StructureFactor, OfALatticeIsItsBraggPeaks) {
  const int columns = 12;
  const Arrangement lattice = triangular_lattice(columns, 6, 1);
  const double first_peak = 4 * kPi / std::sqrt(3.0);
  const Measurement found = measured("structure_factor", lattice, {{"k_max", 1.5 * first_peak}});
  double sum = 0;
  const std::vector<double>& s = column(found, "structure_factor", "S");
  const std::vector<double>& k = column(found, "structure_factor", "k");
  const std::vector<double>& vectors = column(found, "structure_factor", "vectors");
  const double width = 2 * kPi / columns;
  for (std::size_t shell = 0; shell < s.size(); ++shell) {
    sum += s[shell] * vectors[shell];
    if (std::abs(k[shell] - first_peak) > width) {
      EXPECT_NEAR(s[shell], 0, 1e-9);
    }
  }
  EXPECT_NEAR(sum, 3 * columns * columns, 1e-6) << "three of the six first peaks are listed, each N high";
}

TEST(StructureFactor, OfAnIdealGasIsOneWithinErrors) {
  const auto factor = make("structure_factor", random_points(50, {6, 5}, 0), {{"k_max", 12}, {"bins", 8}});
  for (std::uint64_t seed = 0; seed < 320; ++seed) {
    const Arrangement points = random_points(50, {6, 5}, 100 + seed);
    factor->on_frame(points.system, points.frame);
  }
  const Measurement found = factor->result();
  double chi_squared = 0;
  for (std::size_t shell = 0; shell < 8; ++shell) {
    const double error = column(found, "structure_factor", "S_error")[shell];
    const double deviation = (column(found, "structure_factor", "S")[shell] - 1) / error;
    chi_squared += deviation * deviation;
    EXPECT_LT(error, 0.05);
  }
  EXPECT_GT(chi_squared, 0.5);
  EXPECT_LT(chi_squared, 27);
}

// S = 1 at all k, so the fit of its limit must give 1 too.
TEST(StructureFactor, LimitOfAnIdealGasIsOne) {
  const auto factor = make("structure_factor", [] {
    Arrangement points = random_points(200, {30, 30}, 0);
    for (Species& kind : points.system.species) kind.radius = 0.5;
    return points;
  }());
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    const Arrangement points = random_points(200, {30, 30}, 500 + seed);
    factor->on_frame(points.system, points.frame);
  }
  const Estimate limit = test::estimate(factor->result(), "S_0");
  EXPECT_NEAR(limit.value, 1, 4 * *limit.error);
  EXPECT_LT(*limit.error, 0.2);
}

TEST(StructureFactor, NeedsAPeriodicBoxThatWavesFitInto) {
  for (const auto& boundary : {kReflecting, kMixed, kOpen}) {
    EXPECT_THROW(make("structure_factor", random_points(5, {1, 1}, 1, boundary), {{"k_max", 20}}), Error);
  }
  EXPECT_THROW(make("structure_factor", random_points(5, {1, 1}, 1), {{"k_max", 6.28}}), Error);
  EXPECT_THROW(make("structure_factor", random_points(5, {1, 1}, 1), {{"k_max", 1e6}}), Error);
  EXPECT_EQ(column(measured("structure_factor", random_points(5, {1, 1}, 1), {{"k_max", 6.29}}), "structure_factor",
                   "vectors"),
            std::vector<double>{2});
}

}  // namespace
}  // namespace carom
