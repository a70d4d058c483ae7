// Extremes: speeds and masses far apart, flights through many boxes, boxes as narrow as a disk, the wide open plane.
#include <fmt/format.h>

#include "scene_makers.hpp"

namespace carom::test {
namespace {

void set_velocity(Setup& setup, std::size_t k, Vec2 v) {
  setup.frame.vx[k] = v.x;
  setup.frame.vy[k] = v.y;
}

Setup random_gas(Vec2 size, const Boundaries& boundary, std::uint64_t count, std::uint64_t seed) {
  Scene scene = in_box(size, boundary);
  scene.gas.push_back(some_disks(count, 0.5, 1, seed));
  Setup setup = realize(scene);
  turn_inwards(setup);
  return setup;
}

/// All at rest but disk 0.
Setup one_moves(const Boundaries& boundary, std::uint64_t seed) {
  RandomStream random = random_for(seed);
  Setup setup = random_gas({10, 10}, boundary, 30, seed);
  for (std::size_t k = 0; k < setup.system.size(); ++k) set_velocity(setup, k, {});
  set_velocity(setup, seed % setup.system.size(), normal_velocity(random));
  return setup;
}

/// One disk a million times faster than the others.
Setup one_is_fast(const Boundaries& boundary, std::uint64_t seed) {
  Setup setup = random_gas({12, 9}, boundary, 25, seed);
  const std::size_t k = seed % setup.system.size();
  set_velocity(setup, k, 1e6 * setup.frame.velocity(k));
  return setup;
}

/// A heavy disk nearly as high as the box, driven into a light gas.
Scene piston(const Boundaries& boundary, double speed, std::uint64_t seed) {
  Scene scene = in_box({30, 10}, boundary);
  scene.disks.push_back(disk({6, 5}, {speed, 0}, 4.5, 1e6));
  scene.gas.push_back(some_disks(40, 0.5, 1, seed));
  return scene;
}

/// Disks in a channel as wide as `width` along one axis.
Scene channel(const Boundaries& boundary, int axis, double width, std::uint64_t count, std::uint64_t seed) {
  RandomStream random = random_for(seed);
  constexpr double kPitch = 1.6;
  const double length = kPitch * static_cast<double>(count);
  Scene scene = in_box(axis == 0 ? Vec2{width, length} : Vec2{length, width}, boundary);
  for (std::uint64_t k = 0; k < count; ++k) {
    const double along = kPitch * (static_cast<double>(k) + 0.5);
    const bool free = boundary[axis] == Boundary::periodic;
    const double across = free ? between(random, 0, width) : between(random, 0.5, width - 0.5);
    scene.disks.push_back(disk(axis == 0 ? Vec2{across, along} : Vec2{along, across}, normal_velocity(random)));
  }
  shuffle_ids(scene, random);
  return scene;
}

/// A large disk nearly fills the periodic box; small ones rattle between its copies.
Scene caged(double width, double small_radius, std::uint64_t seed) {
  RandomStream random = random_for(seed);
  Scene scene = in_box({width, width}, {Boundary::periodic, Boundary::periodic});
  scene.disks = {disk({0, 0}, normal_velocity(random), 0.5, 3),
                 disk({width / 2, width / 2}, normal_velocity(random), small_radius, 0.1)};
  return scene;
}

Scene two_in(Vec2 size, std::uint64_t seed) {
  RandomStream random = random_for(seed);
  Scene scene = in_box(size, {Boundary::periodic, Boundary::periodic});
  scene.disks = {disk({0.1 * size.x, 0.1 * size.y}, normal_velocity(random)),
                 disk({0.59 * size.x, 0.6 * size.y}, normal_velocity(random))};
  return scene;
}

/// Clusters of disks around distant places, thrown at each other.
Scene distant_clusters(const std::vector<Vec2>& places, Vec2 meeting, std::uint64_t seed) {
  RandomStream random = random_for(seed);
  Scene scene = in_box({}, {Boundary::open, Boundary::open});
  for (const Vec2 place : places) {
    for (int k = 0; k < 9; ++k) {
      const Vec2 offset{1.5 * (k % 3), 1.5 * (k / 3)};
      const Vec2 towards = 1e-2 * (meeting - place);
      scene.disks.push_back(disk(place + offset, towards + normal_velocity(random)));
    }
  }
  shuffle_ids(scene, random);
  return scene;
}

/// Disks that start at `offset` along the open axes, between the walls or seams of the others.
Scene far_out(const Boundaries& boundary, double offset, std::uint64_t seed) {
  RandomStream random = random_for(seed);
  Scene scene = in_box({8, 8}, boundary);
  const Vec2 shift{boundary[0] == Boundary::open ? offset : 0, boundary[1] == Boundary::open ? -offset : 0};
  for (int k = 0; k < 16; ++k) {
    scene.disks.push_back(disk(Vec2{1 + 2.0 * (k % 4), 1 + 2.0 * (k / 4)} + shift, normal_velocity(random)));
  }
  shuffle_ids(scene, random);
  return scene;
}

std::vector<Boundaries> boundaries_with_open() {
  std::vector<Boundaries> found;
  for (const Boundaries& boundary : all_boundaries()) {
    if (boundary[0] == Boundary::open || boundary[1] == Boundary::open) found.push_back(boundary);
  }
  return found;
}

}  // namespace

GeneratedScenes uneven_speeds() {
  GeneratedScenes scenes;
  std::uint64_t seed = 800;
  for (const Boundaries& boundary : all_boundaries()) {
    ++seed;
    scenes.push_back({"all at rest but one, " + name_of(boundary), one_moves(boundary, seed)});
    scenes.push_back({"one disk a million times faster, " + name_of(boundary), one_is_fast(boundary, seed)});
  }
  return scenes;
}

GeneratedScenes pistons() {
  GeneratedScenes scenes;
  std::uint64_t seed = 900;
  for (const Boundaries& boundary : all_boundaries()) {
    ++seed;
    const double speed = seed % 2 == 0 ? 0.1 : 10;
    scenes.push_back({fmt::format("heavy piston at speed {}, {}", speed, name_of(boundary)),
                      realize(piston(boundary, speed, seed))});
  }
  return scenes;
}

GeneratedScenes long_flights() {
  GeneratedScenes scenes;
  std::uint64_t seed = 1000;
  for (const Boundaries& boundary : all_boundaries()) {
    ++seed;
    scenes.push_back(
        {"two disks, free path beyond the box, " + name_of(boundary), random_gas({9, 7}, boundary, 2, seed)});
    scenes.push_back({"twenty disks in a vast box, " + name_of(boundary), random_gas({200, 300}, boundary, 20, seed)});
  }
  return scenes;
}

GeneratedScenes narrow_boxes() {
  constexpr std::array kWidths{1.0, 1.000000001, 1.01, 1.3, 1.9, 2.1};
  GeneratedScenes scenes;
  std::uint64_t seed = 1100;
  for (const double width : kWidths) {
    for (const Boundary along : {Boundary::periodic, Boundary::reflecting, Boundary::open}) {
      const int axis = static_cast<int>(++seed % 2);
      const Boundaries boundary =
          axis == 0 ? Boundaries{Boundary::periodic, along} : Boundaries{along, Boundary::periodic};
      scenes.push_back({fmt::format("channel of width {} on axis {}, {}", width, axis, name_of(boundary)),
                        realize(channel(boundary, axis, width, 6 + seed % 5, seed))});
    }
  }
  const Boundaries walls{Boundary::reflecting, Boundary::periodic};
  scenes.push_back({"channel of width 1.2 between walls", realize(channel(walls, 0, 1.2, 8, ++seed))});
  for (const double width : {1.02, 1.2, 1.4}) {
    scenes.push_back({fmt::format("small disk caged by copies, box {}", width), realize(caged(width, 0.15, ++seed))});
  }
  for (const Vec2 size : {Vec2{1.45, 1.5}, Vec2{2, 2.2}, Vec2{1.05, 2.8}}) {
    scenes.push_back({fmt::format("two disks in a box of {} x {}", size.x, size.y), realize(two_in(size, ++seed))});
  }
  return scenes;
}

GeneratedScenes elongated_boxes() {
  GeneratedScenes scenes;
  std::uint64_t seed = 1200;
  for (const Boundaries& boundary : all_boundaries()) {
    ++seed;
    const double aspect = seed % 3 == 0 ? 2000 : 60;
    const Vec2 size = seed % 2 == 0 ? Vec2{1.7 * aspect, 1.7} : Vec2{1.7, 1.7 * aspect};
    scenes.push_back(
        {fmt::format("box of {} x {}, {}", size.x, size.y, name_of(boundary)), random_gas(size, boundary, 30, seed)});
  }
  return scenes;
}

GeneratedScenes open_plane() {
  GeneratedScenes scenes;
  std::uint64_t seed = 1300;
  for (const double distance : {1e2, 1e4, 1e6}) {
    const std::vector<Vec2> places{{-distance, 0}, {distance, 0.3}, {0.2, distance}};
    scenes.push_back({fmt::format("clusters at a distance of {} fly into each other", distance),
                      realize(distant_clusters(places, {}, ++seed))});
  }
  scenes.push_back({"clusters that never meet", realize(distant_clusters({{-1e6, 3}, {1e5, 1e6}}, {2e6, 0}, ++seed))});
  for (const Boundaries& boundary : boundaries_with_open()) {
    for (const double offset : {1e6, 1e9}) {
      scenes.push_back({fmt::format("disks at an offset of {}, {}", offset, name_of(boundary)),
                        realize(far_out(boundary, offset, ++seed))});
    }
  }
  return scenes;
}

}  // namespace carom::test
