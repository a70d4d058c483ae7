// Displacements and velocity correlations are those of a direct computation from probes of the run, over all pairs of
// frames; slope, diffusion and rate agree with theory.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "carom/observe/theory.hpp"
#include "observe/past_frames.hpp"
#include "observed.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

using test::column;
using test::estimate;
using test::gas;
using test::observe;

constexpr double kInterval = 0.05;
constexpr std::size_t kFrames = 120;

/// Frames by probing, not by replaying.
std::vector<Frame> probed(const carom::Setup& setup) {
  Simulation simulation(setup);
  std::vector<Frame> frames;
  for (std::size_t k = 0; k < kFrames; ++k) {
    simulation.run_until(static_cast<double>(k) * kInterval);
    frames.push_back(simulation.frame());
  }
  return frames;
}

Vec2 unwrapped(const Frame& frame, std::size_t k, Vec2 size) {
  return {frame.x[k] + static_cast<double>(frame.winding_x[k]) * size.x,
          frame.y[k] + static_cast<double>(frame.winding_y[k]) * size.y};
}

/// What a lag's mean must be: over those origins of which both frames are kept at the level that has the lag.
template <typename Pair>
double direct(const std::vector<Frame>& frames, std::uint64_t lag, const Pair& pair) {
  const std::uint64_t stride =
      lag < 16 ? 1 : std::uint64_t{1} << static_cast<int>(std::log2(static_cast<double>(lag) / 8));
  double sum = 0;
  double pairs = 0;
  for (std::uint64_t from = 0; from + lag < frames.size(); from += stride) {
    for (std::size_t k = 0; k < frames[0].size(); ++k) sum += pair(frames[from], frames[from + lag], k);
    pairs += static_cast<double>(frames[0].size());
  }
  return sum / pairs;
}

TEST(Motion, IsThatOfADirectComputation) {
  const carom::Setup setup = realize(gas(40, 0.3));
  const Vec2 size = setup.system.box.size;
  const std::vector<Frame> frames = probed(setup);
  const std::map<std::string, double> options{{"interval", kInterval}, {"levels", 3}};
  ObservableSet set({{.name = "msd", .options = options}, {.name = "vacf", .options = options}},
                    {setup.system, setup.frame});
  Simulation simulation(setup);
  simulation.add_observer(set);
  // Whole windows only: as many frames as the direct computation has.
  while (simulation.time() + simulation.window_start().clock.length <= kFrames * kInterval) simulation.run_window();
  const auto seen = static_cast<std::size_t>(std::ceil(simulation.time() / kInterval));
  const std::vector<Frame> used(frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(seen));
  ASSERT_GT(seen, 64U);

  const Table msd = test::table(set, "msd", "msd");
  const Table vacf = test::table(set, "vacf", "vacf");
  ASSERT_GT(column(msd, "time").size(), 28U);
  for (std::size_t row = 0; row < column(msd, "time").size(); ++row) {
    const auto lag = static_cast<std::uint64_t>(std::lround(column(msd, "time")[row] / kInterval));
    const double expected = direct(used, lag, [&](const Frame& a, const Frame& b, std::size_t k) {
      const Vec2 d = unwrapped(b, k, size) - unwrapped(a, k, size);
      return dot(d, d);
    });
    EXPECT_NEAR(column(msd, "msd")[row], expected, 1e-10 * expected) << "lag " << lag;
    EXPECT_DOUBLE_EQ(column(msd, "diffusion")[row], column(msd, "msd")[row] / (4 * column(msd, "time")[row]));
  }
  const double squares =
      direct(used, 0, [](const Frame& a, const Frame&, std::size_t k) { return dot(a.velocity(k), a.velocity(k)); });
  for (std::size_t row = 0; row < column(vacf, "time").size(); ++row) {
    const auto lag = static_cast<std::uint64_t>(std::lround(column(vacf, "time")[row] / kInterval));
    const double expected = direct(
        used, lag, [](const Frame& a, const Frame& b, std::size_t k) { return dot(a.velocity(k), b.velocity(k)); });
    EXPECT_NEAR(column(vacf, "vacf")[row], expected / squares, 1e-10) << "lag " << lag;
  }
}

TEST(Motion, OfFreeDisksIsStraight) {
  // No collisions: msd = ⟨v²⟩ t², C = 1; along open and periodic axes the drift does not count.
  const Scene scene = test::box_of({50, 40}, Boundary::periodic, Boundary::open,
                                   {test::disk({1, 1}, {2, 0.5}), test::disk({1, 30}, {2, 1.5})});
  const auto set =
      observe(scene, {{.name = "msd", .options = {{"interval", 1}}}, {.name = "vacf", .options = {{"interval", 1}}}},
              {.windows = 60});
  const Table msd = test::table(*set, "msd", "msd");
  for (std::size_t row = 0; row < column(msd, "time").size(); ++row) {
    const double t = column(msd, "time")[row];
    EXPECT_NEAR(column(msd, "msd")[row], 0.25 * t * t, 1e-9 * t * t);
  }
  for (const double c : column(test::table(*set, "vacf", "vacf"), "vacf")) EXPECT_NEAR(c, 1, 1e-12);
}

TEST(PastFrames, FindsEveryLagItHas) {
  PastFrames past(4, 1);
  std::map<std::size_t, int> visits;
  for (int frame = 0; frame < 300; ++frame) {
    const std::vector<double> now{static_cast<double>(frame)};
    past.add(now, [&](std::size_t number, std::span<const double> then) {
      EXPECT_EQ(now[0] - then[0], static_cast<double>(past.lag(number)));
      ++visits[number];
    });
  }
  ASSERT_EQ(visits.size(), past.lags());
  EXPECT_EQ(past.lag(past.lags() - 1), 15U * 8);
  EXPECT_EQ(past.lag(past.first_of_level(2)), 32U);
  EXPECT_EQ(past.lag(past.last_of_level(2)), 60U);
  EXPECT_EQ(visits[0], 300);
  EXPECT_EQ(visits[7], 293);
}

TEST(PastFrames, ChoosesDisksEvenly) {
  EXPECT_EQ(evenly_chosen(5, 10), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(evenly_chosen(10, 4), (std::vector<std::size_t>{0, 2, 5, 7}));
}

// −Γ × 2N/(f+1): the slope is measured from impulses, the rate by counting.
TEST(Motion, StartsToDecayAtTheCollisionRate) {
  const auto set = observe(gas(100, 0.4), {{.name = "vacf"}, {.name = "rate"}}, {.from = 5, .collisions = 60'000});
  const Estimate slope = estimate(*set, "vacf", "initial_slope");
  EXPECT_NEAR(slope.value, *slope.theory, 4 * *slope.error);
  EXPECT_LT(*slope.error, -0.01 * slope.value);
  const Estimate rate = estimate(*set, "rate", "collision_rate");
  EXPECT_NEAR(*slope.theory, -rate.value * 200 / 199, 1e-9);
  // And that is how the measured function begins: by the chord over the shortest lag, less its curvature.
  const Table vacf = test::table(*set, "vacf", "vacf");
  const double t = column(vacf, "time")[1];
  EXPECT_NEAR((column(vacf, "vacf")[1] - 1) / t / slope.value, 1, 0.6 * t * rate.value);
}

TEST(Motion, RateIsThatOfTheory) {
  const auto set = observe(gas(200, 0.3), {{.name = "rate"}}, {.from = 10, .collisions = 200'000});
  const Estimate rate = estimate(*set, "rate", "collision_rate");
  EXPECT_NEAR(rate.value, *rate.theory, 4 * *rate.error);
  const double finite_excess = 2.06326 * (1 - 0.375 / 200) - 1;
  EXPECT_NEAR(*rate.theory, 2.39952 * finite_excess / 1.06326 * finite_rate_factor(398), 1e-4);
  const Estimate time = estimate(*set, "rate", "mean_free_time");
  EXPECT_DOUBLE_EQ(time.value, 1 / rate.value);
  EXPECT_NEAR(*time.error / time.value, *rate.error / rate.value, 1e-12);
  const Estimate path = estimate(*set, "rate", "mean_free_path");
  EXPECT_NEAR(path.value / *path.theory, 1, 0.01);
}

// Exact: the mean time between collisions of two disks is (L² − πd²)/(2 d g), g their relative speed.
TEST(Motion, TwoDisksMeetAsOftenAsTheyMust) {
  const Scene scene = test::box_of({2.5, 2.5}, Boundary::periodic, Boundary::periodic,
                                   {test::disk({0.3, 0.4}, {1, 0.377}), test::disk({1.5, 1.6}, {-1, -0.377})});
  const auto set = observe(scene, {{.name = "rate"}}, {.collisions = 100'000});
  const double g = 2 * std::hypot(1, 0.377);
  const Estimate time = estimate(*set, "rate", "mean_free_time");
  EXPECT_NEAR(*time.theory, (6.25 - kPi) / (2 * g), 1e-12);
  EXPECT_NEAR(time.value, *time.theory, 4 * *time.error);
  EXPECT_LT(*time.error, 0.015 * time.value);
}

TEST(Motion, DiffusionIsNearEnskogs) {
  const auto set = observe(gas(300, 0.2), {{.name = "msd"}, {.name = "vacf"}}, {.from = 10, .collisions = 60'000});
  const Estimate einstein = estimate(*set, "msd", "diffusion");
  const Estimate green_kubo = estimate(*set, "vacf", "diffusion");
  EXPECT_NEAR(einstein.value / *einstein.theory, 1, 0.15);
  EXPECT_NEAR(green_kubo.value / *green_kubo.theory, 1, 0.15);
  EXPECT_NEAR(*einstein.theory, 0.798, 0.001);
}

}  // namespace
}  // namespace carom
