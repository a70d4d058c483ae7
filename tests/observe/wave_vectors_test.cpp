// Property: shells hold the wave vectors of the box, each once and not its opposite; density waves are plain sums.
#include "observe/wave_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "order/arrangements.hpp"

namespace carom {
namespace {

constexpr std::size_t kAll = 1'000'000;

TEST(WaveVectors, AreAllThatFit) {
  const Vec2 box{7, 4};
  const double k_max = 9;
  const WaveVectors waves(box, k_max, 5, kAll);
  std::set<WaveVector> listed(waves.vectors().begin(), waves.vectors().end());
  EXPECT_EQ(listed.size(), waves.vectors().size());
  std::size_t fitting = 0;
  for (int x = -20; x <= 20; ++x) {
    for (int y = -20; y <= 20; ++y) {
      const double k = 2 * kPi * std::hypot(x / box.x, y / box.y);
      if (k > k_max || (x == 0 && y == 0)) continue;
      ++fitting;
      EXPECT_EQ(listed.count({x, y}) + listed.count({-x, -y}), 1U) << x << ' ' << y;
    }
  }
  EXPECT_EQ(2 * listed.size(), fitting);
}

TEST(WaveVectors, ShellsAreDisjointAndGrow) {
  const WaveVectors waves({30, 25}, 10, 40, 400);
  double last = 0;
  std::size_t next = 0;
  EXPECT_EQ(waves.shells().size(), 39U) << "none is narrower than 2π/25";
  for (const WaveShell& shell : waves.shells()) {
    EXPECT_EQ(shell.first, next);
    next = shell.last;
    EXPECT_GT(shell.last, shell.first);
    EXPECT_LE(shell.last - shell.first, 10U);
    EXPECT_GT(shell.mean_k, last);
    EXPECT_GE(shell.mean_k2, shell.mean_k * shell.mean_k * (1 - 1e-12));
    last = shell.mean_k;
  }
  EXPECT_EQ(next, waves.vectors().size());
}

TEST(WaveVectors, AFewStandForManyEvenlyInDirection) {
  const WaveVectors waves({300, 300}, 12, 50, 2000);
  for (const WaveShell& shell : waves.shells()) {
    int first_quadrant = 0;
    int second_quadrant = 0;
    for (std::size_t k = shell.first; k < shell.last; ++k) {
      ++(waves.vectors()[k].x > 0 ? first_quadrant : second_quadrant);
    }
    EXPECT_NEAR(first_quadrant, second_quadrant, 6);
    EXPECT_GT(first_quadrant, 10);
  }
}

TEST(WaveVectors, DensityWavesAreSumsOverDisks) {
  for (const std::size_t count : {1, 8, 13}) {
    const Arrangement points = random_points(count, {7, 4}, 5);
    const WaveVectors waves({7, 4}, 20, 10, kAll);
    const auto found = waves.density_waves(points.frame);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const WaveVector v = waves.vectors()[k];
      std::complex<double> sum = 0;
      for (std::size_t disk = 0; disk < count; ++disk) {
        sum += std::polar(1.0, 2 * kPi * (v.x * points.frame.x[disk] / 7 + v.y * points.frame.y[disk] / 4));
      }
      EXPECT_NEAR(std::abs(found[k] - sum), 0, 1e-11);
    }
  }
}

}  // namespace
}  // namespace carom
