// Property: as long as every disk stays within reach of its list's centre or gets a new list, its list holds every copy
// that touches it, once; and whoever stands in a disk's list has the disk in its own.
#include "window/fast/lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "crowd.hpp"
#include "simd_parameter.hpp"
#include "window/fast/loops.hpp"

namespace carom::fast {
namespace {

constexpr double kSlack = 1e-9;

constexpr double kStart = 3;

/// The same disks with velocities, so that they are where they were at kStart only.
Crowd flying(Crowd crowd) {
  for (Record& own : crowd.records) {
    own.vx = crowd.even();
    own.vy = crowd.even();
    own.x -= kStart * own.vx;
    own.y -= kStart * own.vy;
  }
  return crowd;
}

ListSteps steps_for(Simd simd) { return loops_for(simd, Neighbourhood::lists, true).list_steps; }

/// From kStart on the disks' places are those in their records.
class Walkers {
 public:
  Walkers(Simd simd, const Box& box, int count, std::initializer_list<double> radii, double shell, std::uint64_t seed)
      : crowd(flying(Crowd(box, count, radii, seed))),
        lists(crowd.system, {{0, 0}, box.size}, shell, kSlack, crowd.records, crowd.ids, steps_for(simd), kStart) {
    for (Record& own : crowd.records) {
      const Vec2 place = predict::position_at(own.flight(), kStart);
      own = {place.x, place.y, 0, 0, 0, own.radius, predict::kNever, kNobody, 0};
    }
  }

  /// A disk moves by up to twice what its list allows.
  void move_one() {
    const Index k = crowd.any();
    Record& own = crowd.records[k];
    own.x = inside(0, own.x + 2 * lists.leash() * crowd.even(), own.radius);
    own.y = inside(1, own.y + 2 * lists.leash() * crowd.even(), own.radius);
    const Vec2 gone = Vec2{own.x, own.y} - Vec2{lists[k].x, lists[k].y};
    const bool folded = crowd.below(8) == 0 && crowd.fold(k) != Image{};
    if (!folded && dot(gone, gone) <= lists.leash_squared()) return;
    lists.renew(k, {own.x, own.y});
    ++renewals;
    folds += static_cast<int>(folded);
  }

  [[nodiscard]] std::vector<Vec2> places() const {
    std::vector<Vec2> places;
    for (const Record& own : crowd.records) places.push_back({own.x, own.y});
    return places;
  }

  Crowd crowd;
  Lists lists;
  int renewals = 0;
  int folds = 0;

 private:
  /// Along an open axis disks may leave the extent that the lists were told of, but not for good.
  [[nodiscard]] double inside(int axis, double x, double radius) const {
    const Box& box = crowd.system.box;
    const double size = axis == 0 ? box.size.x : box.size.y;
    if (box.reflecting(axis)) return std::clamp(x, radius, size - radius);
    return box.periodic(axis) ? x : std::clamp(x, -size / 4, 1.25 * size);
  }
};

struct Seen {
  std::size_t touching = 0;
  int brief = 0;
  int lengthened = 0;
};

/// A disk's entries beyond its list are the disk itself.
void expect_padding(const Walkers& walkers, Index k) {
  const List& list = walkers.lists[k];
  for (int m = list.count; m < List::kRoom; ++m) EXPECT_EQ(list.near[m], k) << "entry " << m;
}

void expect_neighbours(const Walkers& walkers, Seen& seen) {
  const std::vector<Vec2> places = walkers.places();
  std::vector<std::vector<Neighbour>> lists;
  for (Index k = 0; k < walkers.crowd.size(); ++k) lists.push_back(neighbours_of(walkers.lists, k));
  for (Index k = 0; k < walkers.crowd.size(); ++k) {
    seen.touching += expect_touching_found(walkers.crowd, k, places, lists[k]);
    expect_wall_known(walkers.crowd, k, places[k], (walkers.lists[k].traits & List::kNearWall) != 0);
    for (const Neighbour& other : lists[k]) {
      EXPECT_TRUE(std::binary_search(lists[other.disk].begin(), lists[other.disk].end(), Neighbour{k, other.image}))
          << other.disk << " does not know " << k;
    }
    const bool brief = (walkers.lists[k].traits & List::kLong) == 0;
    if (brief) expect_padding(walkers, k);
    ++(brief ? seen.brief : seen.lengthened);
  }
}

Seen walk(Walkers& walkers, int rounds) {
  Seen seen;
  for (int round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
    expect_neighbours(walkers, seen);
    for (Index k = 0; k < walkers.crowd.size(); ++k) walkers.move_one();
  }
  EXPECT_GT(walkers.renewals, rounds * walkers.crowd.size() / 4);
  return seen;
}

using ListsTest = ForEverySimd;
INSTANTIATE_TEST_SUITE_P(Lists, ListsTest, every_simd(), test_name_of);

constexpr Boundary kPeriodic = Boundary::periodic;
constexpr Boundary kReflecting = Boundary::reflecting;
constexpr Boundary kOpen = Boundary::open;
constexpr std::array<std::array<Boundary, 2>, 6> kBoundaries{{{kPeriodic, kPeriodic},
                                                              {kPeriodic, kReflecting},
                                                              {kReflecting, kReflecting},
                                                              {kOpen, kOpen},
                                                              {kOpen, kPeriodic},
                                                              {kReflecting, kOpen}}};

TEST_P(ListsTest, HoldAllThatTouchADisk) {
  for (const auto& boundary : kBoundaries) {
    Walkers walkers(GetParam(), {{24, 17}, boundary}, 200, {0.5}, 0.6, 41);
    const Seen seen = walk(walkers, 60);
    EXPECT_GT(seen.touching, 5'000U);
    EXPECT_GT(seen.brief, seen.lengthened);
    EXPECT_TRUE(walkers.folds > 10 || boundary[0] != kPeriodic);
  }
}

TEST_P(ListsTest, HoldAllThatTouchADiskAmongDisksOfManySizes) {
  for (const auto& boundary : kBoundaries) {
    Walkers walkers(GetParam(), {{30, 20}, boundary}, 150, {0.01, 0.05, 0.3, 0.31, 1, 4}, 0.4, 42);
    const Seen seen = walk(walkers, 60);
    EXPECT_GT(seen.touching, 20'000U);
    EXPECT_GT(seen.brief, 500);
    EXPECT_GT(seen.lengthened, 500);
  }
}

TEST_P(ListsTest, HoldSeveralCopiesOfADiskInASmallBox) {
  for (const Vec2 size : {Vec2{1, 1}, Vec2{1.3, 2.1}, Vec2{2.5, 2.5}, Vec2{40, 1.01}}) {
    for (const auto& boundary : {kBoundaries[0], kBoundaries[4]}) {
      Walkers walkers(GetParam(), {size, boundary}, 6, {0.5, 0.4}, 3, 43);
      const Seen seen = walk(walkers, 300);
      EXPECT_GT(seen.touching, 100U);
    }
  }
}

TEST_P(ListsTest, HoldAnyNumberOfDisks) {
  for (const auto& boundary : kBoundaries) {
    Walkers walkers(GetParam(), {{6, 5}, boundary}, 200, {0.5}, 0.5, 44);
    const Seen seen = walk(walkers, 20);
    EXPECT_GT(seen.touching, 30'000U);
    EXPECT_GT(seen.lengthened, 2'000);
  }
}

TEST_P(ListsTest, GrowWithTheShellAndKnowTheirMeanLength) {
  Crowd crowd({{20, 20}, {kPeriodic, kPeriodic}}, 300, {0.5}, 45);
  double before = 0;
  for (const double shell : {0.1, 1.0, 4.0}) {
    const Lists lists(crowd.system, {{0, 0}, {20, 20}}, shell, kSlack, crowd.records, crowd.ids, steps_for(GetParam()));
    std::size_t neighbours = 0;
    for (Index k = 0; k < crowd.size(); ++k) neighbours += neighbours_of(lists, k).size();
    EXPECT_DOUBLE_EQ(lists.mean_length(), static_cast<double>(neighbours) / 300);
    EXPECT_GT(lists.mean_length(), before);
    before = lists.mean_length();
  }
}

}  // namespace
}  // namespace carom::fast
