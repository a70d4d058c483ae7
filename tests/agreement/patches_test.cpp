// Windows divided into patches give the bits of undivided ones: the same events, states and books, however many patches
// and threads there are and however often patches have to be repaired; and none of the checks that see to it is idle.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "generated_scenes.hpp"
#include "recording.hpp"
#include "run/patched_solver.hpp"
#include "scenes.hpp"

namespace carom::test {
namespace {

using Shape = std::array<std::uint32_t, 2>;

constexpr std::array<Shape, 7> kShapes{{{1, 2}, {2, 2}, {3, 5}, {7, 7}, {2, 1}, {4, 3}, {1, 6}}};
constexpr std::array kThreads{1U, 2U, 3U, 8U};

std::string described(const ParallelOptions& parallel) {
  return fmt::format("{} x {} patches, {} threads, near {}, halo {}", (*parallel.patches)[0], (*parallel.patches)[1],
                     parallel.threads, parallel.near, parallel.halo);
}

/// Ways to divide the k-th scene: as it comes, and with copies so few that repairs happen all the time.
std::vector<ParallelOptions> divisions(const Setup& setup, std::size_t k) {
  const double diameter = 2 * setup.system.largest_radius();
  ParallelOptions free;
  free.patches = kShapes[k % kShapes.size()];
  free.threads = kThreads[k % kThreads.size()];
  ParallelOptions shallow;
  shallow.patches = kShapes[(k + 3) % kShapes.size()];
  shallow.threads = kThreads[(k / 2) % kThreads.size()];
  shallow.near = (1.1 + 0.4 * static_cast<double>(k % 3)) * diameter;
  shallow.halo = shallow.near + 0.3 * static_cast<double>(k % 5) * diameter;
  return {free, shallow};
}

Extent extent_of(std::size_t k) { return {.windows = 12, .events = 1200, .probes = static_cast<int>(k % 3)}; }

class DividedScenes : public testing::TestWithParam<SceneGroup> {};

TEST_P(DividedScenes, GiveTheBitsOfUndividedOnes) {
  const GeneratedScenes scenes = GetParam().make();
  std::uint64_t repaired = 0;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const GeneratedScene& scene = scenes[k];
    const Recording expected = record(scene.setup, {}, extent_of(k));
    for (const ParallelOptions& parallel : divisions(scene.setup, k)) {
      Simulation simulation(scene.setup, {}, parallel);
      const auto found = first_difference(expected, record(simulation, extent_of(k)));
      EXPECT_FALSE(found) << "scene: " << scene.name << "\n" << described(parallel) << "\n" << *found;
      EXPECT_EQ(simulation.division().patches, (*parallel.patches)[0] * (*parallel.patches)[1]);
      EXPECT_EQ(simulation.division().threads, parallel.threads);
      repaired += simulation.division().windows_repaired;
    }
  }
  EXPECT_GT(repaired, 0U) << "no halo was too shallow: nothing was tried";
}

INSTANTIATE_TEST_SUITE_P(Of, DividedScenes, testing::ValuesIn(scene_groups().begin(), scene_groups().end()),
                         [](const auto& group) { return std::string(group.param.name); });

/// One window of a system, advanced undivided or in patches.
class OneWindow {
 public:
  OneWindow(const Scene& scene, double length) : setup_(realize(scene)), start_(initial_state(setup_)) {
    start_.clock.length = length;
  }

  [[nodiscard]] std::string undivided() const {
    const auto solver = make_fast_solver(setup_.system);
    return advanced(*solver);
  }
  /// With `checks`, and the copies of `parallel`.
  [[nodiscard]] std::string divided(const ParallelOptions& parallel, const Checks& checks) const {
    const auto solver = make_patched_solver(setup_.system, {}, parallel, checks);
    return advanced(*solver);
  }

  /// The same after the window was begun and abandoned.
  [[nodiscard]] std::string divided_after_interrupt(const ParallelOptions& parallel) const {
    const auto solver = make_patched_solver(setup_.system, {}, parallel);
    Books books(setup_.system.size());
    solver->open(start_, books, nullptr);
    EXPECT_FALSE(solver->advance_to(start_.clock.length, std::atomic<bool>(true)));
    EXPECT_EQ(books.events(), 0U) << "nothing is booked for a window that is abandoned";
    return advanced(*solver);
  }

 private:
  [[nodiscard]] std::string advanced(Solver& solver) const {
    Books books(setup_.system.size());
    State end;
    solver.open(start_, books, nullptr);
    EXPECT_TRUE(solver.advance_to(start_.clock.length, std::atomic<bool>(false)));
    solver.close(end);
    return digest(end.disks);
  }

  Setup setup_;
  State start_;
};

TEST(Patches, AnInterruptedWindowCanBeMadeAgain) {
  const OneWindow window(gas(3000, 0.7), 0.25);
  ParallelOptions parallel;
  parallel.patches = Shape{3, 2};
  parallel.threads = 2;
  EXPECT_EQ(window.divided_after_interrupt(parallel), window.undivided());
}

/// A periodic box of 2000 × 500, patches of which meet at its middle, with disks at rest all over it but there.
constexpr Vec2 kMiddle{1000, 250};

Scene quiet_plane(std::initializer_list<DiskSpec> actors) {
  Scene scene = box_of({2000, 500}, Boundary::periodic, Boundary::periodic, actors);
  for (double x = 3; x < 2000; x += 6) {
    for (double y = 3; y < 500; y += 6) {
      if (std::max(std::abs(x - kMiddle.x), std::abs(y - kMiddle.y)) > 90) scene.disks.push_back(disk({x, y}, {}));
    }
  }
  return scene;
}

ParallelOptions quarters(double near, double halo) {
  ParallelOptions parallel;
  parallel.patches = Shape{2, 2};
  parallel.near = near;
  parallel.halo = halo;
  return parallel;
}

/// The result is right with all checks and wrong without the one that `leave_out` switches off.
template <typename LeaveOut>
void expect_needed(const OneWindow& window, const ParallelOptions& parallel, LeaveOut leave_out) {
  const std::string expected = window.undivided();
  Checks checks;
  EXPECT_EQ(window.divided(parallel, checks), expected);
  leave_out(checks);
  EXPECT_NE(window.divided(parallel, checks), expected) << "this check could be left out";
}

TEST(PatchChecks, NearCopiesHaveToAgreeWithTheirOwners) {
  const OneWindow dense(gas(8000, 0.6), 0.5);
  expect_needed(dense, quarters(4, 5), [](Checks& checks) { checks.near_copies = false; });
}

TEST(PatchChecks, NobodyMayFlyInFromAfar) {
  // The bullet is in nobody's halo; it hits a disk at rest in the patch below on the left.
  const Vec2 flight{-30, -100};
  const OneWindow bullet(quiet_plane({disk(kMiddle + Vec2{-10, -60}, {}), disk(kMiddle + Vec2{20, 40}, flight)}), 1.5);
  expect_needed(bullet, quarters(14, 16), [](Checks& checks) { checks.excursions = false; });
}

TEST(PatchChecks, NearDisksMayNotComeRoundToTheOtherSide) {
  // Both start where two patches meet, each near in the other's, fly apart and meet where the patches meet again. A
  // patch has a copy of the other's disk on the side where it started only.
  const OneWindow meeting(quiet_plane({disk({990, 126}, {-1, 0}), disk({1010, 126}, {1, 0})}), 990.5);
  EXPECT_EQ(meeting.divided(quarters(14, 16), {}), meeting.undivided());
}

TEST(PatchChecks, OwnedDisksMayNotMeetFarCopies) {
  // On its way to the disk at rest in the lower left patch a disk is hit by a heavy one that crosses its way from
  // above. That patch has no copy of the heavy one; its copy of the other goes on and meets the disk at rest.
  const DiskSpec rests = disk(kMiddle - Vec2{16, 16}, {});
  const DiskSpec comes = disk(kMiddle + Vec2{21.5, 21.5}, {-1, -1});
  const DiskSpec crosses = disk(kMiddle + Vec2{15, 46}, {0, -5.45}, 0.5, 1e9);
  const OneWindow crossing(quiet_plane({rests, comes, crosses}), 39);
  expect_needed(crossing, quarters(14, 22), [](Checks& checks) { checks.far_contacts = false; });
}

}  // namespace
}  // namespace carom::test
