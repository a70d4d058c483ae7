// Every disk is owned by one patch; a patch is given all disks within its halo, each once, and knows which are near.
#include "run/layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes.hpp"

namespace carom {
namespace {

constexpr double kNear = 3;
constexpr double kHalo = 9;

/// From a point to a rectangle along the axis where it is farther, over the nearest copy; written apart from Layout.
double distance_to(const Rectangle& owned, Vec2 point, const Box& box) {
  double least = INFINITY;
  for (int nx = -1; nx <= 1; ++nx) {
    for (int ny = -1; ny <= 1; ++ny) {
      if ((nx != 0 && !box.periodic(0)) || (ny != 0 && !box.periodic(1))) continue;
      const Vec2 copy{point.x + nx * box.size.x, point.y + ny * box.size.y};
      const double dx = std::max({owned.low.x - copy.x, copy.x - owned.high.x, 0.0});
      const double dy = std::max({owned.low.y - copy.y, copy.y - owned.high.y, 0.0});
      least = std::min(least, std::max(dx, dy));
    }
  }
  return least;
}

TEST(Layout, WhatIsLoadedReachesAWallToTheLastBit) {
  for (std::size_t disks = 400; disks < 4000; disks += 50) {
    const carom::Setup setup = realize(test::gas(disks, 0.3, Boundary::reflecting));
    Layout layout(setup.system, 3, 3);
    layout.sort(setup.frame);
    Loading loading;
    layout.load(0, kNear, kNear, loading);
    EXPECT_EQ(loading.loaded.low, (Vec2{0, 0}));
    layout.load(8, kNear, kNear, loading);
    EXPECT_EQ(loading.loaded.high, setup.system.box.size) << disks << " disks";
  }
}

class OfBoundary : public testing::TestWithParam<Boundary> {};

TEST_P(OfBoundary, DisksHaveOneOwnerAndAreGivenToThoseNear) {
  const carom::Setup setup = realize(test::gas(4000, 0.3, GetParam()));
  for (const auto& [columns, rows] : {std::pair{1U, 1U}, {4U, 3U}, {7U, 1U}, {1U, 2U}}) {
    Layout layout(setup.system, columns, rows);
    layout.sort(setup.frame);
    std::vector<int> owners(setup.system.size(), 0);
    for (std::size_t patch = 0; patch < layout.patches(); ++patch) {
      Loading loading;
      layout.load(patch, kNear, kHalo, loading);
      std::vector<int> given(setup.system.size(), 0);
      for (std::size_t k = 0; k < loading.disks.size(); ++k) {
        const DiskId id = loading.disks[k];
        ++given[id];
        owners[id] += static_cast<int>(loading.roles[k] == Role::owned);
        const double away = distance_to(layout.owned(patch), setup.frame.position(id), setup.system.box);
        if (std::abs(away) < 1e-9 || std::abs(away - kNear) < 1e-9) continue;  // on an edge, but for rounding
        const Role expected = away == 0 ? Role::owned : away < kNear ? Role::near : Role::far;
        EXPECT_EQ(loading.roles[k], expected) << "disk " << id << " is " << away << " away";
        const bool all_the_time = loading.whole || away < 2 * kNear;
        EXPECT_EQ(loading.shares[k] == 1, all_the_time) << "disk " << id << " is " << away << " away";
        EXPECT_GE(loading.shares[k], 0);
      }
      for (DiskId id = 0; id < setup.system.size(); ++id) {
        EXPECT_LE(given[id], 1);
        const double away = distance_to(layout.owned(patch), setup.frame.position(id), setup.system.box);
        if (loading.whole || away < kHalo) {
          EXPECT_EQ(given[id], 1) << "disk " << id << " is missing";
        }
      }
    }
    for (const int count : owners) EXPECT_EQ(count, 1);
  }
}

TEST_P(OfBoundary, PathsTouchTheTerritoriesThatTheyPass) {
  const carom::Setup setup = realize(test::gas(4000, 0.3, GetParam()));
  Layout layout(setup.system, 4, 4);
  layout.sort(setup.frame);
  const Rectangle own = layout.owned(5);  // not at an edge
  const double length = setup.system.box.size.x;
  EXPECT_TRUE(layout.touches(5, {own.low, own.high}, 0));
  EXPECT_TRUE(layout.touches(5, {{own.high.x + 1, own.low.y}, {own.high.x + 2, own.high.y}}, 1.5));
  EXPECT_FALSE(layout.touches(5, {{own.high.x + 1, own.low.y}, {own.high.x + 2, own.high.y}}, 0.5));
  const Rectangle copy{{own.low.x - 3 * length, own.low.y + 2 * length},
                       {own.high.x - 3 * length, own.high.y + 2 * length}};
  EXPECT_EQ(layout.touches(5, copy, 0), GetParam() == Boundary::periodic) << "a path over seams";
  const Rectangle beyond{{-9, own.low.y}, {-8, own.high.y}};
  EXPECT_EQ(layout.touches(4, beyond, 0), GetParam() != Boundary::periodic) << "what lies beyond the outermost patch";
}

INSTANTIATE_TEST_SUITE_P(In, OfBoundary, testing::Values(Boundary::periodic, Boundary::reflecting));

}  // namespace
}  // namespace carom
