// Few disks do what is known exactly: two in a periodic box, Galperin's billiard, the cradle, one disk between walls.
#include <gtest/gtest.h>

#include <cmath>

#include "carom/carom/presets.hpp"
#include "carom/run/simulation.hpp"
#include "carom/run/summary.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::box_of;
using test::disk;

// Two disks of diameter d in a periodic square of side L, total momentum zero, relative speed g: one is a point in a
// Sinai billiard with a scatterer of radius d. Santaló: mean time between collisions (L² − πd²)/(2 d g); from it
// the excess of the compressibility, Z_ex = πd²/[2 (L² − πd²)].
TEST(TwoDisks, MeetAsOftenAsInSinaisBilliard) {
  for (const double side : {2.5, 4.0}) {
    Simulation simulation(realize(box_of({side, side}, Boundary::periodic, Boundary::periodic,
                                         {disk({0.3, 0.7}, {0.31, 0.95}), disk({1.6, 1.9}, {-0.31, -0.95})})));
    while (simulation.books().collisions < 1'000'000) simulation.run_window();
    const double g = 2 * std::sqrt(0.31 * 0.31 + 0.95 * 0.95);
    const double between = simulation.time() / static_cast<double>(simulation.books().collisions);
    const double exact = (side * side - kPi) / (2 * g);
    EXPECT_NEAR(between / exact, 1, 4e-3);
    const double z_ex = *summarize(simulation).pressure * side * side / 2 - 1;
    EXPECT_NEAR(z_ex / (kPi / (2 * (side * side - kPi))), 1, 4e-3);
  }
}

// G. Galperin, Regular and Chaotic Dynamics 8, 375 (2003).
TEST(Galperin, CountsTheDigitsOfPi) {
  const std::array<std::uint64_t, 6> expected{3, 31, 314, 3141, 31415, 314159};
  for (int digits = 1; digits <= 6; ++digits) {
    const SceneFile file = make_galperin(digits);
    Simulation simulation(realize(file.scene));
    simulation.run_until(*file.run.until);
    EXPECT_EQ(simulation.books().events(), expected[digits - 1]);
    EXPECT_TRUE(violations(summarize(simulation)).empty());
  }
}

TEST(Cradle, PassesTheMomentumAlongTheRowAndBack) {
  const SceneFile file = make_cradle(5);
  Simulation simulation(realize(file.scene));
  const auto velocities_at = [&](double time) {
    simulation.run_until(time);
    return simulation.frame().vx;
  };
  EXPECT_EQ(velocities_at(1), (std::vector<double>{1, 0, 0, 0, 0}));
  EXPECT_EQ(velocities_at(4), (std::vector<double>{0, 0, 0, 0, 1}));
  EXPECT_EQ(velocities_at(9), (std::vector<double>{0, 0, 0, 0, -1}));
  EXPECT_EQ(velocities_at(15), (std::vector<double>{-1, 0, 0, 0, 0}));
  EXPECT_EQ(summarize(simulation).energy_drift, 0);
}

TEST(OneDisk, KeepsItsSpeedOverAMillionWallHits) {
  Simulation simulation(
      realize(box_of({3, 2}, Boundary::reflecting, Boundary::reflecting, {disk({1.3, 0.9}, {0.7, 0.45})})));
  while (simulation.books().wall_collisions < 1'000'000) simulation.run_window();
  const Frame frame = simulation.frame();
  EXPECT_EQ(std::abs(frame.vx[0]), 0.7);
  EXPECT_EQ(std::abs(frame.vy[0]), 0.45);
  EXPECT_LT(simulation.books().largest_overlap, 1e-14);
  // Unfolded, the flight is a straight line; the centre's range is 2 wide and 1 high.
  const auto folded = [](double unfolded, double range) {
    const double phase = std::fmod(unfolded, 2 * range);
    return phase > range ? 2 * range - phase : phase;
  };
  EXPECT_NEAR(frame.x[0] - 0.5, folded(0.8 + 0.7 * frame.time, 2), 1e-8);
  EXPECT_NEAR(frame.y[0] - 0.5, folded(0.4 + 0.45 * frame.time, 1), 1e-8);
}

TEST(OneDisk, LosesItsNormalSpeedByTheWallsRestitution) {
  Scene scene = box_of({3, 2}, Boundary::reflecting, Boundary::open, {disk({1, 1}, {1, 0.25})});
  scene.wall_restitution = 0.5;
  Simulation simulation(realize(scene));
  simulation.run_until(1.5 + 4 + 1);  // hits right at 1.5, left at 5.5
  EXPECT_EQ(simulation.frame().velocity(0), (Vec2{0.25, 0.25}));
}

TEST(TwoDisks, PartAtRightAnglesIfOneWasAtRest) {
  const SceneFile file = make_two_disks();
  Simulation simulation(realize(file.scene));
  simulation.run_until(*file.run.until);
  const Frame frame = simulation.frame();
  EXPECT_EQ(simulation.books().collisions, 1U);
  EXPECT_NEAR(dot(frame.velocity(0), frame.velocity(1)), 0, 1e-15);
  EXPECT_NEAR(frame.vx[0], 0.64, 1e-15);
  EXPECT_NEAR(frame.vy[1], 0.48, 1e-15);
}

}  // namespace
}  // namespace carom
