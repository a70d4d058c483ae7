// Property: the number of pairs of an ideal gas is exact under any boundary but an open one.
#include "observe/ideal_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "carom/base/error.hpp"
#include "order/arrangements.hpp"

namespace carom {
namespace {

TEST(IdealPairs, PeriodicBoxesCountAllImages) {
  const IdealPairs ideal({{3, 2}, kPeriodic}, 0.5, 0.1);
  EXPECT_NEAR(ideal.between(0.5, 4), kPi * (16 - 0.25) / 6, 1e-13);
  EXPECT_NEAR(ideal.density(2.5), 2 * kPi * 2.5 / 6, 1e-13);
}

// Isotropised set covariance of a rectangle a × b, for r below both sides: ab − 2(a + b)r/π + r²/π.
TEST(IdealPairs, BetweenWallsCirclesReachBeyondThem) {
  const double a = 3 - 0.4;
  const double b = 2 - 0.4;
  const IdealPairs ideal({{3, 2}, kReflecting}, 0.2, 0.2);
  for (const double r : {0.1, 0.7, 1.5}) {
    const double covariance = a * b - 2 * (a + b) * r / kPi + r * r / kPi;
    EXPECT_NEAR(ideal.density(r), 2 * kPi * r * covariance / (a * b * a * b), 1e-12) << r;
  }
  const IdealPairs mixed({{3, 2}, kMixed}, 0.2, 0.2);
  EXPECT_NEAR(mixed.density(1.1), 2 * kPi * 1.1 * (b - 2 * 1.1 / kPi) / (3 * b * b), 1e-12);
}

TEST(IdealPairs, EveryPairIsSomewhere) {
  for (const double radius_b : {0.2, 0.5, 0.9}) {
    const IdealPairs ideal({{3, 2}, kReflecting}, 0.2, radius_b);
    double sum = 0;
    for (int bin = 0; bin < 400; ++bin) sum += ideal.between(0.01 * bin, 0.01 * (bin + 1));
    EXPECT_NEAR(sum, 1, 1e-8) << radius_b;
  }
}

TEST(IdealPairs, AgreesWithRandomPairsOfTwoSizes) {
  const double radius_a = 0.1;
  const double radius_b = 0.45;
  const IdealPairs ideal({{3, 2}, kReflecting}, radius_a, radius_b);
  RandomStream random(3, 0, 0);
  const auto place = [&random](double size, double radius) { return radius + (size - 2 * radius) * random.uniform(); };
  const int tries = 100'000;
  int near = 0;
  for (int n = 0; n < tries; ++n) {
    const double dx = place(3, radius_a) - place(3, radius_b);
    const double r = std::hypot(dx, place(2, radius_a) - place(2, radius_b));
    if (r > 0.6 && r < 1.4) ++near;
  }
  const double share = ideal.between(0.6, 1.4);
  EXPECT_NEAR(near / static_cast<double>(tries), share, 4 * std::sqrt(share * (1 - share) / tries));
}

TEST(IdealPairs, AnOpenPlaneHasNoDensity) { EXPECT_THROW(IdealPairs({{3, 2}, kOpen}, 0.1, 0.1), Error); }

}  // namespace
}  // namespace carom
