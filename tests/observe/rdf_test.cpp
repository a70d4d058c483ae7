// Property: g(r) is what a loop over all pairs counts, 1 for an ideal gas, exact for two disks.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "carom/base/error.hpp"
#include "frames.hpp"

namespace carom {
namespace {

using test::column;
using test::estimate;
using test::make;
using test::measured;

constexpr double kRange = 2;
constexpr std::size_t kBins = 40;

/// Pairs of kinds a and b by bin, nearest images only, over what an ideal gas has in a periodic box.
std::vector<double> by_hand(const Arrangement& points, std::uint32_t a, std::uint32_t b) {
  std::vector<double> counts(kBins, 0);
  double pairs = 0;
  for (std::size_t i = 0; i < points.frame.size(); ++i) {
    for (std::size_t j = 0; j < points.frame.size(); ++j) {
      if (i == j || points.system.species_of[i] != a || points.system.species_of[j] != b) continue;
      ++pairs;
      const double r = length(test::nearest_image(points, i, j));
      if (r < kRange) ++counts[static_cast<std::size_t>(r / kRange * kBins)];
    }
  }
  const double area = points.system.box.size.x * points.system.box.size.y;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const double low = kRange * static_cast<double>(bin) / kBins;
    const double high = kRange * static_cast<double>(bin + 1) / kBins;
    counts[bin] /= pairs * kPi * (high * high - low * low) / area;
  }
  return counts;
}

void expect_same(const std::vector<double>& found, const std::vector<double>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], wanted[k], 1e-11 * (1 + wanted[k]));
}

TEST(Rdf, IsWhatALoopOverAllPairsCounts) {
  const Arrangement points = random_points(300, {9, 5}, 1);
  const Measurement found = measured("rdf", points, {{"r_max", kRange}, {"bins", kBins}});
  expect_same(column(found, "rdf", "g"), by_hand(points, 0, 0));
  EXPECT_NEAR(column(found, "rdf", "r")[3], 3.5 * kRange / kBins, 1e-12);
}

TEST(Rdf, HasAPartialFunctionForEveryPairOfKinds) {
  Arrangement points({9, 5});
  RandomStream random(2, 0, 0);
  for (int k = 0; k < 200; ++k) {
    const double x = 9 * random.uniform();
    points.add({x, 5 * random.uniform()}, k % 3 == 0 ? 1e-9 : 2e-9);
  }
  const Measurement found = measured("rdf", points, {{"r_max", kRange}, {"bins", kBins}});
  expect_same(column(found, "rdf", "g_AA"), by_hand(points, 0, 0));
  expect_same(column(found, "rdf", "g_AB"), by_hand(points, 0, 1));
  expect_same(column(found, "rdf", "g_BB"), by_hand(points, 1, 1));
  for (std::uint32_t& kind : points.system.species_of) kind = 0;
  expect_same(column(found, "rdf", "g"), by_hand(points, 0, 0));
}

TEST(Rdf, OfManyKindsIsTheTotalAlone) {
  Arrangement points = random_points(50, {9, 5}, 3);
  for (int k = 0; k < 4; ++k) points.add({0.3 + k, 2.2}, 1e-8 * (k + 1));
  const Measurement found = measured("rdf", points, {{"r_max", kRange}, {"bins", kBins}});
  for (std::uint32_t& kind : points.system.species_of) kind = 0;
  expect_same(column(found, "rdf", "g"), by_hand(points, 0, 0));
  EXPECT_THROW(column(found, "rdf", "g_AA"), std::out_of_range);
  EXPECT_TRUE(found.estimates.empty());
}

TEST(Rdf, OfAnIdealGasIsOneWithinErrorsBetweenAnyWalls) {
  for (const auto& boundary : {kPeriodic, kReflecting, kMixed}) {
    const auto rdf = make("rdf", random_points(100, {4, 3}, 0, boundary), {{"r_max", 3.5}, {"bins", 20}});
    for (std::uint64_t seed = 0; seed < 320; ++seed) {
      const Arrangement points = random_points(100, {4, 3}, seed, boundary);
      rdf->on_frame(points.system, points.frame);
    }
    const Measurement found = rdf->result();
    double chi_squared = 0;
    for (std::size_t bin = 0; bin < 20; ++bin) {
      const double deviation = (column(found, "rdf", "g")[bin] - 1) / column(found, "rdf", "g_error")[bin];
      chi_squared += deviation * deviation;
      EXPECT_LT(column(found, "rdf", "g_error")[bin], 0.05);
    }
    EXPECT_GT(chi_squared, 4);
    EXPECT_LT(chi_squared, 55);
  }
}

// Two disks: every place of the second outside the first is equally likely, so g = A/(A − πσ²) from contact on.
TEST(Rdf, ContactValueOfTwoDisksIsExact) {
  const double side = 2.5;
  Arrangement two({side, side});
  two.add({0.2, 2.3}, 0.5);
  two.add({1.5, 1.0}, 0.5);
  const auto rdf = make("rdf", two);
  RandomStream random(4, 0, 0);
  for (int frame = 0; frame < 40'000;) {
    two.frame.x[1] = side * random.uniform();
    two.frame.y[1] = side * random.uniform();
    if (length(test::nearest_image(two, 0, 1)) < 1) continue;
    rdf->on_frame(two.system, two.frame);
    ++frame;
  }
  const Estimate contact = estimate(rdf->result(), "contact_value");
  const double exact = side * side / (side * side - kPi);
  ASSERT_TRUE(contact.error.has_value());
  EXPECT_NEAR(contact.value, exact, 3 * *contact.error);
  EXPECT_LT(*contact.error, 0.05 * exact);
  EXPECT_GT(contact.blocks, 0U);
  // Z = 1 + 2ηg(N − 1)/N is then that of two disks, 1 + πd²/[2(L² − πd²)].
  const Estimate z = estimate(rdf->result(), "Z");
  EXPECT_NEAR(z.value, 1 + kPi / (2 * (side * side - kPi)), 3 * *z.error);
}

TEST(Rdf, OfATriangularLatticeHasSixNeighboursInTheFirstShell) {
  const Arrangement lattice = triangular_lattice(12, 6, 1);
  const Measurement found = measured("rdf", lattice, {{"r_max", 2}, {"bins", 8}});
  const double density = 2 / std::sqrt(3.0) * 143 / 144;
  const std::vector<double>& g = column(found, "rdf", "g");
  // The neighbours at distance 1 stand at the edge between two bins.
  const double around = density * kPi * (g[3] * (1 - 0.75 * 0.75) + g[4] * (1.25 * 1.25 - 1));
  EXPECT_NEAR(around, 6, 1e-9);
  EXPECT_EQ(g[0], 0);
}

TEST(Rdf, NeedsPairsAndADensity) {
  EXPECT_THROW(make("rdf", random_points(5, {1, 1}, 1, kOpen)), Error);
  EXPECT_THROW(make("rdf", random_points(1, {1, 1}, 1)), Error);
  EXPECT_THROW(make("rdf", random_points(5, {1, 1}, 1), {{"bins", 0}}), Error);
  EXPECT_THROW(make("rdf", random_points(5, {1, 1}, 1), {{"r_max", 0}}), Error);
}

}  // namespace
}  // namespace carom
