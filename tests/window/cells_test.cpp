// Property: whatever crossings and folds have happened, the nine cells around a disk hold every copy that touches it,
// once, and their slots tell the same wherever they say that they tell all.
#include "window/fast/cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "crowd.hpp"

namespace carom::fast {
namespace {

constexpr double kSlack = 1e-9;

/// Disks flying about in a grid, each up to a time of its own.
class Flyers {
 public:
  Flyers(const Box& box, int count, std::initializer_list<double> radii, double width, std::uint64_t seed)
      : crowd(box, count, radii, seed),
        cells(crowd.system, {}, width, kSlack, crowd.records, crowd.ids),
        now_(crowd.records.size(), 0) {
    for (Index k = 0; k < crowd.size(); ++k) turn_about(k);
  }

  /// A disk flies on within its cell, or into the next one, or has an event of its own.
  void move_one() {
    const Index k = crowd.any();
    const double crosses = cells.crossing_of_any(k);
    const double until = std::min({crosses, meets_wall(k), now_[k] + 1});
    if (until == crosses && crowd.below(3) > 0) {
      now_[k] = crosses;
      cells.cross(k);
      ++crossings;
    } else {
      now_[k] += crowd.uniform() * (until - now_[k]);
      if (crowd.below(2) == 0) have_event(k);
    }
  }

  [[nodiscard]] std::vector<Vec2> places() const {
    std::vector<Vec2> places;
    for (Index k = 0; k < crowd.size(); ++k) {
      places.push_back(predict::position_at(crowd.records[k].flight(), now_[k]));
    }
    return places;
  }

  Crowd crowd;
  Cells cells;
  int crossings = 0;
  int folds = 0;

 private:
  void turn_about(Index k) {
    Record& own = crowd.records[k];
    own.vx = crowd.below(6) == 0 ? 0 : crowd.even();
    own.vy = crowd.below(6) == 0 ? 0 : crowd.even();
  }
  void have_event(Index k) {
    Record& own = crowd.records[k];
    const Vec2 place = predict::position_at(own.flight(), now_[k]);
    own.x = place.x;
    own.y = place.y;
    own.t = now_[k];
    turn_about(k);
    const Image turns = crowd.fold(k);
    if (turns == Image{}) return;
    cells.fold(k, turns);
    ++folds;
  }
  [[nodiscard]] double meets_wall(Index k) const {
    double time = predict::kNever;
    for (const Wall wall : {Wall::left, Wall::right, Wall::bottom, Wall::top}) {
      if (!crowd.system.box.reflecting(axis_of(wall))) continue;
      const Record& own = crowd.records[k];
      time = std::min(time, contact_of_disk_and_wall(own.flight(), own.radius, wall, crowd.system.box.size));
    }
    return time;
  }

  std::vector<double> now_;
};

/// What the slots of the nine cells tell, as the hot loop reads them; nothing if one of them does not tell all.
std::vector<Neighbour> told_by_slots(const Flyers& flyers, Index k, bool& all) {
  const Place& place = flyers.cells[k];
  const Image own = flyers.cells.turns(k);
  std::vector<Neighbour> told;
  all = true;
  for (std::int32_t row = place.row - 1; row <= place.row + 1; ++row) {
    const Index* slots = flyers.cells.slots(place.column - 1, row);
    for (int m = 0; m < 3 * Cells::kSlots; ++m) {
      if (slots[m] == Slot::kEmpty) continue;
      all = all && Slot::says_all(slots[m]);
      const Index other = Slot::disk(slots[m]);
      const Image copy = Slot::image(slots[m]);
      const Image image{copy.x + own.x, copy.y + own.y};
      if (other != k) {
        told.push_back({other, flyers.crowd.ids[k] < flyers.crowd.ids[other] ? image : Image{-image.x, -image.y}});
      } else if (Slot::says_all(slots[m])) {
        EXPECT_EQ(image, Image{}) << "disk " << k << " meets itself";
      }
    }
  }
  std::sort(told.begin(), told.end());
  return told;
}

struct Seen {
  std::size_t touching = 0;
  int plain = 0;
  int closer = 0;
};

void expect_neighbours(const Flyers& flyers, Seen& seen) {
  const std::vector<Vec2> places = flyers.places();
  for (Index k = 0; k < flyers.crowd.size(); ++k) {
    const std::vector<Neighbour> found = neighbours_of(flyers.cells, k);
    seen.touching += expect_touching_found(flyers.crowd, k, places, found);
    expect_wall_known(flyers.crowd, k, places[k], (flyers.cells[k].traits & Place::kNearWall) != 0);
    bool all = false;
    const std::vector<Neighbour> told = told_by_slots(flyers, k, all);
    EXPECT_TRUE(!all || told == found) << "the slots around disk " << k << " tell something else";
    ++(all ? seen.plain : seen.closer);
  }
}

Seen fly(Flyers& flyers, int rounds) {
  Seen seen;
  for (int round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
    expect_neighbours(flyers, seen);
    for (Index k = 0; k < flyers.crowd.size(); ++k) flyers.move_one();
  }
  EXPECT_GT(flyers.crossings, rounds * flyers.crowd.size() / 20);
  return seen;
}

constexpr Boundary kPeriodic = Boundary::periodic;
constexpr Boundary kReflecting = Boundary::reflecting;
constexpr std::array<std::array<Boundary, 2>, 4> kBoundaries{
    {{kPeriodic, kPeriodic}, {kPeriodic, kReflecting}, {kReflecting, kPeriodic}, {kReflecting, kReflecting}}};

TEST(Cells, HoldAllThatTouchADiskInABoxOfManyCells) {
  for (const auto& boundary : kBoundaries) {
    Flyers flyers({{24, 17}, boundary}, 250, {0.5, 0.7}, 1.6, 31);
    const Seen seen = fly(flyers, 60);
    EXPECT_GT(seen.touching, 10'000U);
    EXPECT_GT(seen.plain, seen.closer);
    EXPECT_TRUE(flyers.folds > 100 || flyers.crowd.system.box.conserved_axes() == 0);
  }
}

TEST(Cells, HoldAllThatTouchADiskInTheSmallestBox) {
  const double smallest = 4 * (1 + kSlack);
  for (const auto& boundary : kBoundaries) {
    Flyers flyers({{smallest, smallest}, boundary}, 14, {0.5}, 1, 32);
    ASSERT_TRUE(Cells::fit(flyers.crowd.system, {}, kSlack));
    EXPECT_EQ(flyers.cells.width().x, smallest / 4);
    const Seen seen = fly(flyers, 400);
    EXPECT_GT(seen.touching, 3000U);
  }
}

TEST(Cells, HoldMoreDisksThanTheyHaveSlots) {
  for (const auto& boundary : kBoundaries) {
    Flyers flyers({{8, 6}, boundary}, 300, {0.5, 0.1}, 1, 33);
    const Seen seen = fly(flyers, 40);
    EXPECT_GT(seen.touching, 100'000U);
    EXPECT_GT(seen.closer, 5'000);
  }
}

TEST(Cells, KnowDisksThatHaveFlownOverManySeams) {
  Flyers flyers({{5, 5}, {kPeriodic, kPeriodic}}, 20, {0.5}, 1, 34);
  for (Index k = 0; k < 10; ++k) flyers.crowd.records[k].vx = 1000;  // crossings of one disk come one by one
  const Seen seen = fly(flyers, 300);
  EXPECT_GT(seen.touching, 3000U);
  int far = 0;
  for (Index k = 0; k < flyers.crowd.size(); ++k) {
    while (std::abs(flyers.cells.turns(k).x) < 4 && flyers.crowd.records[k].vx != 0) {
      flyers.cells.crossing_of_any(k);
      flyers.cells.cross(k);
    }
    far += std::abs(flyers.cells.turns(k).x) >= 4;
  }
  EXPECT_GT(far, 10);
}

TEST(Cells, FitWhereNoCellIsTwoNeighboursOfAnother) {
  Crowd crowd({{4, 4}, {kPeriodic, kPeriodic}}, 3, {0.5}, 35);
  EXPECT_TRUE(Cells::fit(crowd.system, {}, 0));
  EXPECT_FALSE(Cells::fit(crowd.system, {}, 1e-12));
  crowd.system.box.boundary[1] = Boundary::open;
  EXPECT_FALSE(Cells::fit(crowd.system, {}, 0));
}

}  // namespace
}  // namespace carom::fast
