// What the agreement tests stand on: the scenes reach the difficult cases, and the comparison sees a single bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "generated_scenes.hpp"
#include "recording.hpp"
#include "scenes.hpp"

namespace carom::test {
namespace {

constexpr SolverOptions kReference{.kind = SolverKind::reference};

Recording granular_recording() {
  Scene scene = gas(20, 0.3, Boundary::reflecting);
  scene.restitution = 0.9;
  return record(realize(scene), kReference, {.windows = 4, .events = 50});
}

void flip_last_bit(double& value) { value = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ 1); }

template <typename Whole>
void flip_last_bit(Whole& value) {
  value = static_cast<Whole>(value ^ 1);
}

struct Change {
  const char* of;
  std::function<void(WindowTrace&)> make;
};

/// One change of each thing that is compared.
std::vector<Change> all_changes() {
  std::vector<Change> changes;
  const auto add = [&](const char* of, auto part) {
    changes.push_back({of, [part](WindowTrace& window) { flip_last_bit(part(window)); }});
  };
  using W = WindowTrace;
  add("time", [](W& w) -> double& { return w.end.events[7].time; });
  add("generation", [](W& w) -> std::uint32_t& { return w.end.events[7].generation; });
  add("i", [](W& w) -> DiskId& { return w.end.events[7].i; });
  add("j", [](W& w) -> DiskId& { return w.end.events[7].j; });
  add("image.x", [](W& w) -> std::int32_t& { return w.end.events[7].image.x; });
  add("image.y", [](W& w) -> std::int32_t& { return w.end.events[7].image.y; });
  add("point.x", [](W& w) -> double& { return w.end.events[7].point.x; });
  add("point.y", [](W& w) -> double& { return w.end.events[7].point.y; });
  add("normal.x", [](W& w) -> double& { return w.end.events[7].normal.x; });
  add("normal.y", [](W& w) -> double& { return w.end.events[7].normal.y; });
  add("impulse", [](W& w) -> double& { return w.end.events[7].impulse; });
  add("event in flight", [](W& w) -> double& { return w.probes[0].events[3].impulse; });
  add("probed x", [](W& w) -> double& { return w.probes[1].frame.x[5]; });
  add("y", [](W& w) -> double& { return w.end.frame.y[5]; });
  add("vx", [](W& w) -> double& { return w.end.frame.vx[5]; });
  add("vy", [](W& w) -> double& { return w.end.frame.vy[5]; });
  add("winding_x", [](W& w) -> std::int64_t& { return w.end.frame.winding_x[5]; });
  add("winding_y", [](W& w) -> std::int64_t& { return w.end.frame.winding_y[5]; });
  add("collisions", [](W& w) -> std::uint64_t& { return w.end.books.collisions; });
  add("wall_collisions", [](W& w) -> std::uint64_t& { return w.end.books.wall_collisions; });
  add("ties", [](W& w) -> std::uint64_t& { return w.end.books.ties; });
  add("collapses", [](W& w) -> std::uint64_t& { return w.end.books.collapses; });
  add("largest_overlap", [](W& w) -> double& { return w.end.books.largest_overlap; });
  add("events_of", [](W& w) -> std::uint64_t& { return w.end.books.events_of[5]; });
  add("virial_of", [](W& w) -> double& { return w.end.books.virial_of[5]; });
  add("wall_impulse_of", [](W& w) -> double& { return w.probes[1].books.wall_impulse_of[5]; });
  add("window", [](W& w) -> std::uint64_t& { return w.after.clock.window; });
  add("start", [](W& w) -> double& { return w.after.clock.start; });
  add("length", [](W& w) -> double& { return w.after.clock.length; });
  add("last_contact", [](W& w) -> double& { return w.after.last_contact[5]; });
  add("state", [](W& w) -> double& { return w.after.disks.x[5]; });
  changes.push_back({"order", [](W& w) { std::swap(w.end.events[4], w.end.events[5]); }});
  changes.push_back({"missing event", [](W& w) { w.end.events.pop_back(); }});
  changes.push_back({"event too many", [](W& w) { w.end.events.push_back(w.end.events.back()); }});
  changes.push_back({"sign of zero", [](W& w) { w.end.books.wall_impulse_of[5] = -w.end.books.wall_impulse_of[5]; }});
  return changes;
}

TEST(Comparison, SeesASingleBit) {
  const Recording recording = granular_recording();
  ASSERT_GE(recording.windows.size(), 3U);
  EXPECT_EQ(first_difference(recording, granular_recording()), std::nullopt);
  for (const Change& change : all_changes()) {
    Recording changed = recording;
    change.make(changed.windows[2]);
    const auto found = first_difference(recording, changed);
    ASSERT_TRUE(found) << change.of;
    EXPECT_TRUE(found->starts_with("window 2, ")) << *found;
  }
  Recording shorter = recording;
  shorter.windows.pop_back();
  EXPECT_TRUE(first_difference(recording, shorter));
}

/// What can happen in a scene that a solver may get wrong.
struct Reached {
  std::size_t scenes = 0;
  std::uint64_t events = 0;
  std::uint64_t ties = 0;
  std::uint64_t collapses = 0;
  int farthest_image = 0;
  std::size_t pairs_through_two_images = 0;  // in one window
  std::set<std::pair<Boundary, Boundary>> boundaries;
  std::set<std::string> names;
  std::size_t most_disks = 0;
};

void note_images(const WindowTrace& window, Reached& reached) {
  std::set<std::tuple<DiskId, DiskId, Image>> met;
  for (const Collision& event : window.end.events) {
    if (is_wall(event.j)) continue;
    reached.farthest_image = std::max({reached.farthest_image, std::abs(event.image.x), std::abs(event.image.y)});
    met.insert({event.i, event.j, event.image});
  }
  const auto same_pair = [](const auto& a, const auto& b) {
    return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b);
  };
  for (auto it = met.begin(); (it = std::adjacent_find(it, met.end(), same_pair)) != met.end(); ++it) {
    ++reached.pairs_through_two_images;
  }
}

void note(const GeneratedScene& scene, Reached& reached) {
  const Recording recording = record(scene.setup, kReference, {.windows = 6, .events = 300});
  const Box& box = scene.setup.system.box;
  ++reached.scenes;
  reached.events += recording.books().events();
  reached.ties += recording.books().ties;
  reached.collapses += recording.books().collapses;
  reached.boundaries.insert({box.boundary[0], box.boundary[1]});
  reached.names.insert(scene.name);
  reached.most_disks = std::max(reached.most_disks, scene.setup.system.size());
  for (const WindowTrace& window : recording.windows) note_images(window, reached);
}

TEST(GeneratedScenes, ReachTheDifficultCases) {
  Reached reached;
  for (const SceneGroup& group : scene_groups()) {
    for (const GeneratedScene& scene : group.make()) note(scene, reached);
  }
  EXPECT_GE(reached.scenes, 240U);
  EXPECT_EQ(reached.names.size(), reached.scenes) << "two scenes have one name";
  EXPECT_EQ(reached.boundaries.size(), 9U);
  EXPECT_GE(reached.most_disks, 500U);
  EXPECT_GE(reached.events, 30'000U);
  EXPECT_GE(reached.ties, 1000U);
  EXPECT_GE(reached.collapses, 100U);
  EXPECT_GE(reached.farthest_image, 5);
  EXPECT_GE(reached.pairs_through_two_images, 50U);
}

}  // namespace
}  // namespace carom::test
