// The window map keeps its contract: events in their total order, positions touched only by a disk's own events,
// every image that can be reached is considered, no pair approaches after its collision, ties are ordered and counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "carom/predict/contact.hpp"
#include "carom/run/simulation.hpp"
#include "carom/window/solver.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::box_of;
using test::disk;
using test::gas;

const std::atomic<bool> kNotInterrupted{false};

/// One window of a scene, solved in one go.
struct Solved {
  Setup setup;
  State start;
  State end;
  Books books{0};
  std::vector<Collision> log;

  Solved(const Scene& scene, double length)
      : setup(realize(scene)), start(initial_state(setup)), books(setup.system.size()) {
    start.clock.length = length;
    const auto solver = make_reference_solver(setup.system);
    solver->open(start, books, &log);
    EXPECT_TRUE(solver->advance_to(length, kNotInterrupted));
    solver->close(end);
  }
};

TEST(Window, HeadOnCollisionHappensWhereAndWhenItMust) {
  const Solved solved(box_of({10, 10}, Boundary::open, Boundary::open, {disk({2, 5}, {1, 0}), disk({5, 5}, {0, 0})}),
                      8);
  ASSERT_EQ(solved.log.size(), 1U);
  const Collision& collision = solved.log[0];
  EXPECT_EQ(collision.time, 2);
  EXPECT_EQ(collision.i, 0U);
  EXPECT_EQ(collision.j, 1U);
  EXPECT_EQ(collision.normal, (Vec2{1, 0}));
  EXPECT_EQ(collision.point, (Vec2{4.5, 5}));
  EXPECT_EQ(collision.impulse, 1);
  EXPECT_EQ(solved.end.disks.position(0), (Vec2{4, 5}));
  EXPECT_EQ(solved.end.disks.position(1), (Vec2{11, 5}));
}

TEST(Window, HoldsEventsBeforeItsEndOnly) {
  const Scene scene = box_of({10, 10}, Boundary::open, Boundary::open, {disk({2, 5}, {1, 0}), disk({5, 5}, {0, 0})});
  const Solved solved(scene, 2);
  EXPECT_TRUE(solved.log.empty()) << "a contact at the very end belongs to the next window";
  EXPECT_EQ(solved.end.disks.velocity(0), (Vec2{1, 0}));
}

TEST(Window, WallsTurnTheNormalVelocityOnly) {
  const Solved solved(box_of({4, 4}, Boundary::reflecting, Boundary::reflecting, {disk({2, 2}, {1, 0.25})}), 4);
  ASSERT_EQ(solved.log.size(), 1U);
  EXPECT_EQ(solved.log[0].time, 1.5);
  EXPECT_EQ(solved.log[0].j, id_of(Wall::right));
  EXPECT_EQ(solved.log[0].impulse, 2);
  EXPECT_EQ(solved.log[0].point, (Vec2{4, 2.375}));
  EXPECT_EQ(solved.end.disks.velocity(0), (Vec2{-1, 0.25}));
  EXPECT_EQ(solved.books.wall_collisions, 1U);
}

TEST(Window, LongFlightsMeetDistantImages) {
  // The flight passes the resting disk's column at times 0.1, 0.3, 0.5 and 0.7 and meets its copy (4, 2) at 0.9.
  const Vec2 velocity{50, 24.4 / 0.9};
  const Scene scene = box_of({10, 10}, Boundary::periodic, Boundary::periodic,
                             {disk({1, 1}, velocity, 0.1), disk({6, 5.4}, {0, 0}, 0.1)});
  const Solved solved(scene, 1);
  ASSERT_FALSE(solved.log.empty());
  EXPECT_EQ(solved.log[0].image, (Image{4, 2}));
  double first = predict::kNever;
  for (int nx = -8; nx <= 8; ++nx) {
    for (int ny = -8; ny <= 8; ++ny) {
      first = std::min(
          first, predict::contact_of_disks({{1, 1}, velocity, 0}, {{6, 5.4}, {0, 0}, 0}, {10.0 * nx, 10.0 * ny}, 0.2));
    }
  }
  EXPECT_EQ(solved.log[0].time, first);
}

TEST(Window, TwoImagesOfOnePairAtOnceAreTwoEvents) {
  // In a narrow box a disk flies up between two copies of the other and touches both at the same time.
  const Scene scene =
      box_of({1.5, 8}, Boundary::periodic, Boundary::open, {disk({0.25, 2}, {0, 1}), disk({1, 4}, {0, 0})});
  const Solved solved(scene, 4);
  ASSERT_GE(solved.log.size(), 2U);
  EXPECT_EQ(solved.log[0].time, solved.log[1].time);
  EXPECT_EQ(solved.log[0].image, (Image{-1, 0}));
  EXPECT_EQ(solved.log[1].image, (Image{0, 0}));
  EXPECT_EQ(solved.log[1].generation, 1U);
  EXPECT_GE(solved.books.ties, 1U);
}

TEST(Window, CradleRunsThroughTheRowAtOneTime) {
  Scene scene = box_of({20, 4}, Boundary::open, Boundary::open, {disk({1, 2}, {1, 0})});
  for (int k = 0; k < 5; ++k) scene.disks.push_back(disk({4.0 + k, 2}, {0, 0}));
  const Solved solved(scene, 8);
  ASSERT_EQ(solved.log.size(), 5U);
  for (std::uint32_t k = 0; k < 5; ++k) {
    EXPECT_EQ(solved.log[k].time, 2);
    EXPECT_EQ(solved.log[k].generation, k);
    EXPECT_EQ(solved.log[k].i, k);
  }
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(solved.end.disks.velocity(k), (Vec2{0, 0}));
  EXPECT_EQ(solved.end.disks.velocity(5), (Vec2{1, 0}));
  EXPECT_EQ(solved.books.ties, 4U);
}

TEST(Window, TiesAreTakenBySmallerId) {
  // Two moving disks hit a resting one from both sides at once.
  const Scene scene = box_of({20, 4}, Boundary::open, Boundary::open,
                             {disk({8, 2}, {-1, 0}), disk({2, 2}, {1, 0}), disk({5, 2}, {0, 0})});
  const Solved solved(scene, 4);
  ASSERT_GE(solved.log.size(), 3U);
  EXPECT_EQ(solved.log[0].i, 0U);
  EXPECT_EQ(solved.log[0].j, 2U);
  EXPECT_EQ(solved.log[1].i, 1U);
  EXPECT_EQ(solved.log[1].generation, 1U);
  EXPECT_EQ(solved.end.disks.velocity(2), (Vec2{0, 0}));
  EXPECT_EQ(solved.end.disks.velocity(0), (Vec2{1, 0}));
}

TEST(Window, EventsAreProcessedInOrderOfTime) {
  for (const double packing : {0.1, 0.5, 0.78}) {
    const Solved solved(gas(60, packing), 4);
    ASSERT_GT(solved.log.size(), 10U);
    EXPECT_TRUE(std::is_sorted(solved.log.begin(), solved.log.end(),
                               [](const Collision& a, const Collision& b) { return a.time < b.time; }));
  }
}

TEST(Window, ReadingInsideChangesNothing) {
  const Scene scene = gas(50, 0.6);
  const Solved straight(scene, 2);

  const carom::Setup setup = realize(scene);
  State start = initial_state(setup);
  start.clock.length = 2;
  Books books(setup.system.size());
  const auto solver = make_reference_solver(setup.system);
  solver->open(start, books, nullptr);
  Frame frame;
  for (int k = 1; k <= 1000; ++k) {
    ASSERT_TRUE(solver->advance_to(2.0 * k / 1000, kNotInterrupted));
    solver->read(2.0 * k / 1000, frame);
  }
  State end;
  solver->close(end);
  EXPECT_EQ(end.disks.x, straight.end.disks.x);
  EXPECT_EQ(end.disks.vy, straight.end.disks.vy);
  EXPECT_EQ(books.collisions, straight.books.collisions);
}

TEST(Window, AccountsAddUp) {
  const Solved solved(gas(80, 0.5, Boundary::reflecting), 2);
  std::uint64_t events = 0;
  double impulse_on_walls = 0;
  for (const std::uint64_t of_one : solved.books.events_of) events += of_one;
  EXPECT_EQ(events, 2 * solved.books.collisions + solved.books.wall_collisions);
  EXPECT_EQ(solved.log.size(), solved.books.events());
  double virial = 0;
  for (const Collision& collision : solved.log) {
    (is_wall(collision.j) ? impulse_on_walls : virial) += collision.impulse;  // contact distance is 1
  }
  double booked_virial = 0;
  double booked_impulse = 0;
  for (std::size_t k = 0; k < 80; ++k) {
    booked_virial += solved.books.virial_of[k];
    booked_impulse += solved.books.wall_impulse_of[k];
  }
  EXPECT_NEAR(booked_virial, virial, 1e-11 * virial);
  EXPECT_NEAR(booked_impulse, impulse_on_walls, 1e-11 * impulse_on_walls);
}

TEST(Window, WindingsUnwrapTheFlight) {
  const Solved solved(box_of({4, 6}, Boundary::periodic, Boundary::periodic, {disk({1, 1}, {-3, 5})}), 8);
  EXPECT_EQ(solved.end.disks.x[0] + 4 * static_cast<double>(solved.end.disks.winding_x[0]), 1 - 24);
  EXPECT_EQ(solved.end.disks.y[0] + 6 * static_cast<double>(solved.end.disks.winding_y[0]), 1 + 40);
}

TEST(Window, TcRuleEndsInelasticCollapse) {
  // Three disks between walls at low restitution would collide without end; the TC rule makes them part.
  Scene scene = box_of({4.2, 4}, Boundary::reflecting, Boundary::open,
                       {disk({0.55, 2}, {1, 0}), disk({2.1, 2}, {0, 0}), disk({3.65, 2}, {-1, 0})});
  scene.restitution = 0.05;
  const Solved solved(scene, 1024);
  EXPECT_GT(solved.books.collapses, 0U);
  EXPECT_LT(solved.log.size(), 100'000U);
  EXPECT_LE(solved.books.largest_overlap, 1e-9);
}

TEST(Window, InterruptStopsBetweenEvents) {
  const carom::Setup setup = realize(gas(50, 0.6));
  State start = initial_state(setup);
  start.clock.length = 16;
  Books books(setup.system.size());
  const auto solver = make_reference_solver(setup.system);
  const std::atomic<bool> interrupted{true};
  solver->open(start, books, nullptr);
  EXPECT_FALSE(solver->advance_to(16, interrupted));
  EXPECT_EQ(books.collisions, 0U);
}

TEST(Window, NoPairApproachesRightAfterItsCollision) {
  for (const double restitution : {0.0, 0.3, 1.0}) {
    Scene scene = gas(40, 0.5);
    scene.restitution = restitution;
    const Solved solved(scene, 1);
    for (std::size_t k = 1; k < solved.log.size(); ++k) {
      const Collision& a = solved.log[k - 1];
      const Collision& b = solved.log[k];
      EXPECT_FALSE(a.time == b.time && a.i == b.i && a.j == b.j && a.image == b.image)
          << "disks " << a.i << " and " << a.j << " collided twice at " << a.time;
    }
  }
}

}  // namespace
}  // namespace carom
