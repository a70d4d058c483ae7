// Property: every two disks and image within the range are visited once, and no others, under any boundary.
#include "carom/order/pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "arrangements.hpp"
#include "carom/base/error.hpp"

namespace carom {
namespace {

/// Smaller id, larger id, distance.
using Pair = std::tuple<std::size_t, std::size_t, double>;

std::vector<Pair> from_grid(const Arrangement& points, double range) {
  std::vector<Pair> pairs;
  PairGrid(points.system.box, points.frame, range).for_each([&](std::size_t i, std::size_t j, Vec2 r) {
    pairs.emplace_back(std::min(i, j), std::max(i, j), length(r));
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Every pair with every image, one by one.
std::vector<Pair> one_by_one(const Arrangement& points, double range) {
  const Box& box = points.system.box;
  const Frame& frame = points.frame;
  const int images_x = box.periodic(0) ? static_cast<int>(range / box.size.x) + 2 : 0;
  const int images_y = box.periodic(1) ? static_cast<int>(range / box.size.y) + 2 : 0;
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    for (std::size_t j = i; j < frame.size(); ++j) {
      for (int nx = -images_x; nx <= images_x; ++nx) {
        for (int ny = -images_y; ny <= images_y; ++ny) {
          if (i == j && (nx < 0 || (nx == 0 && ny <= 0))) continue;
          const Vec2 r = frame.position(j) - frame.position(i) + Vec2{nx * box.size.x, ny * box.size.y};
          if (length(r) <= range) pairs.emplace_back(i, j, length(r));
        }
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void expect_same(const Arrangement& points, double range) {
  const std::vector<Pair> found = from_grid(points, range);
  const std::vector<Pair> wanted = one_by_one(points, range);
  ASSERT_EQ(found.size(), wanted.size()) << points.frame.size() << " disks, range " << range;
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(std::get<0>(found[k]), std::get<0>(wanted[k]));
    EXPECT_EQ(std::get<1>(found[k]), std::get<1>(wanted[k]));
    EXPECT_NEAR(std::get<2>(found[k]), std::get<2>(wanted[k]), 1e-12);
  }
}

TEST(PairGrid, FindsWhatALoopOverAllPairsFinds) {
  for (const auto& boundary : {kPeriodic, kReflecting, kOpen, kMixed}) {
    for (const double range : {0.3, 1.0, 2.7, 5.0}) {
      expect_same(random_points(120, {10, 7}, 1, boundary), range);
      expect_same(random_points(150, {60, 1.5}, 2, boundary), range);
    }
  }
}

TEST(PairGrid, CountsEveryImageBeyondHalfABox) {
  for (const double range : {0.6, 1.0, 3.3}) {
    expect_same(random_points(1, {1, 1}, 3), range);
    expect_same(random_points(2, {1, 1.5}, 4), range);
    expect_same(random_points(7, {1.2, 1}, 5, kMixed), range);
  }
}

TEST(PairGrid, TakesPositionsOutsideThePeriodicBox) {
  Arrangement points({4, 4});
  points.add({-0.1, 4.1});
  points.add({8.2, 0.0});
  points.add({2, -2});
  const std::vector<Pair> pairs = from_grid(points, 0.5);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_NEAR(std::get<2>(pairs[0]), std::hypot(0.3, 0.1), 1e-12);
}

TEST(PairGrid, TakesNoDisksOneDiskAndALineOfThem) {
  expect_same(Arrangement({1, 1}, kOpen), 1);
  expect_same(random_points(1, {1, 1}, 1, kOpen), 1);
  Arrangement line({0, 0}, kOpen);
  for (int k = 0; k < 50; ++k) line.add({0.37 * k * k, 5});
  expect_same(line, 8);
}

TEST(PairGrid, NeedsAProperRange) {
  const Arrangement points = random_points(3, {1, 1}, 1);
  for (const double range : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e200, 20.1}) {
    EXPECT_THROW(PairGrid(points.system.box, points.frame, range), Error) << range;
  }
}

}  // namespace
}  // namespace carom
