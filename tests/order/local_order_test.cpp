// Property: ψ6 is 1 in a perfect triangular lattice, turns six times as fast as the lattice, and is 0 in a square one.
#include "carom/order/local_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "arrangements.hpp"

namespace carom {
namespace {

TEST(LocalOrder, TriangularLattice) {
  const Arrangement lattice = triangular_lattice(9, 5, 1.1);
  const LocalOrder order = local_order(lattice.system, lattice.frame);
  ASSERT_EQ(order.psi6.size(), 90U);
  for (std::size_t k = 0; k < 90; ++k) {
    EXPECT_EQ(order.neighbours[k], 6U);
    EXPECT_NEAR(std::abs(order.psi6[k] - 1.0), 0, 1e-12);
    EXPECT_NEAR(order.density[k], kPi * 0.16 / (std::sqrt(3.0) / 2), 1e-6);
  }
}

TEST(LocalOrder, TurnsSixTimesAsFastAsTheLattice) {
  const double angle = 0.2;
  Arrangement hexagon({0, 0}, kOpen);
  hexagon.add({5, 5}, 0.5);
  for (int k = 0; k < 6; ++k) {
    const double direction = angle + k * kPi / 3;
    hexagon.add({5 + std::cos(direction), 5 + std::sin(direction)}, 0.5);
  }
  const LocalOrder order = local_order(hexagon.system, hexagon.frame);
  EXPECT_EQ(order.neighbours[0], 6U);
  EXPECT_NEAR(std::arg(order.psi6[0]), 6 * angle, 1e-12);
  EXPECT_NEAR(std::abs(order.psi6[0]), 1, 1e-12);
}

TEST(LocalOrder, SquareLatticeHasNone) {
  const Arrangement lattice = square_lattice(10, 0.7);
  const LocalOrder order = local_order(lattice.system, lattice.frame);
  for (std::size_t k = 0; k < 100; ++k) {
    EXPECT_EQ(order.neighbours[k], 4U);
    EXPECT_NEAR(std::abs(order.psi6[k]), 0, 1e-12) << "1 - 1 + 1 - 1";
  }
}

TEST(LocalOrder, IsTheMeanOfSixfoldAngles) {
  const Arrangement points = random_points(200, {4, 4}, 21, kMixed);
  const VoronoiCells cells = voronoi_cells(points.system, points.frame);
  const LocalOrder order = local_order(points.system, cells);
  for (std::size_t k = 0; k < 200; ++k) {
    std::complex<double> sum = 0;
    for (const VoronoiNeighbour& n : cells.of(k)) sum += std::polar(1.0, 6 * std::atan2(n.r.y, n.r.x));
    EXPECT_NEAR(std::abs(order.psi6[k] - sum / static_cast<double>(order.neighbours[k])), 0, 1e-12);
  }
}

TEST(LocalOrder, ALoneDiskHasNoOrder) {
  const Arrangement one = random_points(1, {1, 1}, 2, kReflecting);
  const LocalOrder order = local_order(one.system, one.frame);
  EXPECT_EQ(order.neighbours[0], 0U);
  EXPECT_EQ(order.psi6[0], 0.0);
}

}  // namespace
}  // namespace carom
