// A window played again from its start and its collisions shows what the run itself shows inside it.
#include "carom/observe/replay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "carom/run/simulation.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

/// Replays every window at some times.
class Replaying : public Observer {
 public:
  void on_window(const WindowRecord& window) override {
    WindowReplay replay(window);
    for (int k = 0; k < 3; ++k)
      frames.push_back(replay.at(window.before.clock.start + k * window.before.clock.length / 3));
    EXPECT_EQ(digest(frames[frames.size() - 3]), digest(window.before.disks)) << "at a window's start, its bits";
  }
  std::vector<Frame> frames;
};

void expect_near(const Frame& actual, const Frame& expected, const Box& box) {
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const Vec2 turns{static_cast<double>(actual.winding_x[k] - expected.winding_x[k]),
                     static_cast<double>(actual.winding_y[k] - expected.winding_y[k])};
    EXPECT_NEAR(actual.x[k] + turns.x * box.size.x, expected.x[k], 1e-11);
    EXPECT_NEAR(actual.y[k] + turns.y * box.size.y, expected.y[k], 1e-11);
    EXPECT_NEAR(actual.vx[k], expected.vx[k], 1e-11);
    EXPECT_NEAR(actual.vy[k], expected.vy[k], 1e-11);
  }
}

class Replayed : public testing::TestWithParam<Scene> {};

TEST_P(Replayed, ShowsWhatProbesShow) {
  Simulation simulation(realize(GetParam()));
  Replaying replaying;
  simulation.add_observer(replaying);
  std::vector<Frame> probed;
  for (int window = 0; window < 4; ++window) {
    const Clock clock = simulation.window_start().clock;
    for (int k = 0; k < 3; ++k) {
      simulation.run_until(clock.start + k * clock.length / 3);
      probed.push_back(simulation.frame());
    }
    simulation.run_window();
  }
  ASSERT_EQ(replaying.frames.size(), probed.size());
  for (std::size_t k = 0; k < probed.size(); ++k) {
    EXPECT_EQ(replaying.frames[k].time, probed[k].time);
    expect_near(replaying.frames[k], probed[k], simulation.system().box);
  }
}

Scene granular(Boundary boundary) {
  Scene scene = test::gas(40, 0.3, boundary);
  scene.gas.push_back(scene.gas.front());
  scene.gas.back().mass = 3;
  scene.gas.back().radius = 0.4;
  scene.restitution = 0.8;
  return scene;
}

INSTANTIATE_TEST_SUITE_P(Replay, Replayed,
                         testing::Values(test::gas(60, 0.6), test::gas(60, 0.3, Boundary::reflecting),
                                         test::gas(30, 0.2, Boundary::open), granular(Boundary::periodic),
                                         granular(Boundary::reflecting)));

TEST(Replay, AContactAtTheVeryTimeIsStillToCome) {
  const Scene scene = test::box_of({8, 8}, Boundary::reflecting, Boundary::reflecting, {test::disk({2, 2}, {1, 0})});
  class AtContact : public Observer {
   public:
    void on_window(const WindowRecord& window) override {
      if (window.collisions.empty() || seen > 0) return;
      ++seen;
      const double time = window.before.clock.start + window.collisions[0].time;
      WindowReplay replay(window);
      EXPECT_EQ(replay.at(time).vx[0], 1);
      EXPECT_EQ(replay.at(time + 1e-9).vx[0], -1);
    }
    int seen = 0;
  } observer;
  Simulation simulation(realize(scene));
  simulation.add_observer(observer);
  while (observer.seen == 0) simulation.run_window();
}

}  // namespace
}  // namespace carom
