// Disks anywhere in a box, overlapping or not, and who touches whom by looking at all of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <random>
#include <tuple>
#include <vector>

#include "carom/state/state.hpp"
#include "window/encounter.hpp"
#include "window/fast/huge_pages.hpp"
#include "window/fast/neighbour.hpp"
#include "window/fast/record.hpp"

namespace carom::fast {

constexpr bool operator==(const Neighbour& a, const Neighbour& b) { return a.disk == b.disk && a.image == b.image; }
constexpr bool operator<(const Neighbour& a, const Neighbour& b) {
  return std::tie(a.disk, a.image) < std::tie(b.disk, b.image);
}

/// The members are what Cells and Lists take.
struct Crowd {
  System system;
  Array<Record> records;
  Array<DiskId> ids;
  std::mt19937_64 random;

  Crowd(const Box& box, int count, std::initializer_list<double> radii, std::uint64_t seed) : random(seed) {
    system.box = box;
    std::vector<double> radius_of(radii);
    for (int k = 0; k < count; ++k) system.add_disk({radius_of[static_cast<std::size_t>(k) % radius_of.size()], 1});
    for (int k = 0; k < count; ++k) ids.push_back(static_cast<DiskId>(k));
    std::shuffle(ids.begin(), ids.end(), random);
    for (const DiskId id : ids) {
      const double radius = system.radius(id);
      const double x = start(0, radius);
      records.push_back({x, start(1, radius), 0, 0, 0, radius, predict::kNever, kNobody, 0});
    }
  }

  [[nodiscard]] Index size() const { return static_cast<Index>(records.size()); }
  std::size_t below(std::size_t bound) { return random() % bound; }
  Index any() { return static_cast<Index>(below(records.size())); }
  double uniform() { return static_cast<double>(random() >> 11) * 0x1p-53; }
  double even() { return 2 * uniform() - 1; }

  /// Folds a position into the box where it is periodic; returns how many periods were taken off.
  Image fold(Index k) {
    Image turns;
    if (system.box.periodic(0)) turns.x = fold(records[k].x, system.box.size.x);
    if (system.box.periodic(1)) turns.y = fold(records[k].y, system.box.size.y);
    return turns;
  }

  /// The copies of other disks that touch or overlap disk k, all disks at `places`.
  [[nodiscard]] std::vector<Neighbour> touching(Index k, const std::vector<Vec2>& places) const {
    std::vector<Neighbour> touching;
    for (Index other = 0; other < size(); ++other) {
      if (other == k) continue;
      const double sigma = records[k].radius + records[other].radius;
      const Vec2 r = places[other] - places[k];
      const auto [first_x, last_x] = images(0, r.x, sigma);
      const auto [first_y, last_y] = images(1, r.y, sigma);
      for (std::int32_t x = first_x; x <= last_x; ++x) {
        for (std::int32_t y = first_y; y <= last_y; ++y) {
          const Vec2 apart = r + shift_of({x, y}, system.box.size);
          if (dot(apart, apart) > sigma * sigma) continue;
          touching.push_back({other, ids[k] < ids[other] ? Image{x, y} : Image{-x, -y}});
        }
      }
    }
    return touching;
  }

 private:
  double start(int axis, double radius) {
    const double size = axis == 0 ? system.box.size.x : system.box.size.y;
    return system.box.reflecting(axis) ? radius + (size - 2 * radius) * uniform() : size * uniform();
  }
  static std::int32_t fold(double& coordinate, double size) {
    const Wrapped wrapped = wrap(coordinate, size);
    coordinate = wrapped.coordinate;
    return static_cast<std::int32_t>(wrapped.turns);
  }
  /// First and last image that can lie within `reach` of the origin along an axis.
  [[nodiscard]] std::pair<std::int32_t, std::int32_t> images(int axis, double r, double reach) const {
    if (!system.box.periodic(axis)) return {0, 0};
    const double size = axis == 0 ? system.box.size.x : system.box.size.y;
    return {static_cast<std::int32_t>(std::floor((-r - reach) / size)),
            static_cast<std::int32_t>(std::ceil((-r + reach) / size))};
  }
};

/// Sorted; expects that none stands there twice.
template <class Near>
std::vector<Neighbour> neighbours_of(const Near& near, Index k) {
  std::vector<Neighbour> found;
  near.for_neighbours(k, [&](const Neighbour& neighbour) { found.push_back(neighbour); });
  std::sort(found.begin(), found.end());
  EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "disk " << k << " has a neighbour twice";
  return found;
}

/// Expects that all that touch disk k are among `found`; returns how many they are.
inline std::size_t expect_touching_found(const Crowd& crowd, Index k, const std::vector<Vec2>& places,
                                         const std::vector<Neighbour>& found) {
  const std::vector<Neighbour> touching = crowd.touching(k, places);
  for (const Neighbour& other : touching) {
    EXPECT_TRUE(std::binary_search(found.begin(), found.end(), other))
        << "disk " << k << " does not know disk " << other.disk << ", image " << other.image.x << ' ' << other.image.y;
  }
  return touching.size();
}

/// Expects `knows_wall` if the disk at `place` touches a wall.
inline void expect_wall_known(const Crowd& crowd, Index k, Vec2 place, bool knows_wall) {
  const Box& box = crowd.system.box;
  const double radius = crowd.records[k].radius;
  const bool touches = (box.reflecting(0) && (place.x <= radius || place.x >= box.size.x - radius)) ||
                       (box.reflecting(1) && (place.y <= radius || place.y >= box.size.y - radius));
  EXPECT_TRUE(knows_wall || !touches) << "disk " << k << " does not know the wall";
}

}  // namespace carom::fast
