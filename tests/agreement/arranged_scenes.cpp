// A few disks arranged so that several meet at one time, touch from the start, or stand on seams and corners.
#include <fmt/format.h>

#include "scene_makers.hpp"

namespace carom::test {
namespace {

/// Disks that come to one place from all sides at the same time, with or without one that waits there.
Scene meeting_in_the_middle(const Boundaries& boundary, bool with_middle, bool diagonal) {
  Scene scene = in_box({12, 12}, boundary);
  constexpr std::array<Vec2, 4> kStraight{Vec2{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  constexpr std::array<Vec2, 4> kDiagonal{Vec2{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (const Vec2 side : diagonal ? kDiagonal : kStraight) scene.disks.push_back(disk(Vec2{6, 6} + 4 * side, -side));
  if (with_middle) scene.disks.push_back(disk({6, 6}, {}));
  return scene;
}

/// Disks that leave through the corner, along the edges, and stand on the seams.
Scene corners_and_seams(const Boundaries& boundary) {
  const bool x = boundary[0] == Boundary::periodic;
  const bool y = boundary[1] == Boundary::periodic;
  Scene scene = in_box({8, 8}, boundary);
  scene.disks = {disk({4, 4}, {1, 1}), disk({x ? 0 : 0.5, y ? 0 : 0.5}, {}), disk({6, 2}, {1, -1}),
                 disk({x ? 8 : 7.5, 4}, {0, 1}), disk({2, y ? 8 : 7.5}, {1, 0})};
  return scene;
}

/// A disk that flies midway between two copies of another one and meets both at the same time.
Scene between_copies(Boundary along, int axis, double speed) {
  const auto at = [axis](double across, double up) { return axis == 0 ? Vec2{across, up} : Vec2{up, across}; };
  Scene scene =
      in_box(at(1.5, 8), axis == 0 ? Boundaries{Boundary::periodic, along} : Boundaries{along, Boundary::periodic});
  scene.disks = {disk(at(0.25, 5), {}), disk(at(1, 2), at(0, speed)), disk(at(0.25, 7), at(0, -2 * speed))};
  return scene;
}

/// Disks at rest that overlap by what is tolerated: a pair, a disk and a wall, two disks across a seam. One flies by.
Scene tolerated_overlaps(const Boundaries& boundary, std::uint64_t seed) {
  constexpr double kOverlap = 5e-10;
  const double deepest = (1 - 0.3 * static_cast<double>(seed % 3)) * kOverlap;
  const double low = boundary[0] == Boundary::reflecting ? 0.5 : 0;
  Scene scene = in_box({9, 9}, boundary);
  scene.disks = {disk({4, 1}, {}), disk({5 - deepest, 1}, {}), disk({low, 6}, {}), disk({5, 8}, {0.5, 0})};
  if (boundary[0] == Boundary::reflecting) scene.disks[2].position.x -= 0.7 * kOverlap;
  if (boundary[0] == Boundary::periodic) scene.disks.push_back(disk({8 + 0.9 * kOverlap, 6}, {}));
  return scene;
}

/// Equal disks in a row along an axis; the first ones fly into the others, which rest and touch.
Scene cradle(const Boundaries& boundary, int axis, int resting, int flying) {
  const int count = resting + flying;
  const double row = count + 4.0;
  Scene scene = in_box(axis == 0 ? Vec2{row, 3} : Vec2{3, row}, boundary);
  for (int k = 0; k < count; ++k) {
    const bool flies = k < flying;
    const double along = flies ? 0.5 + k : 2.5 + k;
    const double speed = flies ? 1 : 0;
    scene.disks.push_back(axis == 0 ? disk({along, 1.5}, {speed, 0}) : disk({1.5, along}, {0, speed}));
  }
  return scene;
}

/// A rack of touching disks at rest, and one that breaks it.
Scene rack(const Boundaries& boundary, int rows, double aim) {
  constexpr double kRowHeight = 0.8660254037844387;  // a hair over √3/2: no overlap
  const double size = 3.0 * rows + 4;
  Scene scene = in_box({size, size}, boundary);
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k <= row; ++k) {
      scene.disks.push_back(disk({size / 2 + k - 0.5 * row, 4 + row * kRowHeight}, {}));
    }
  }
  scene.disks.push_back(disk({size / 2 + aim, 1.5}, {0, 3}));
  return scene;
}

/// Touching disks that move: every pair is in contact at the start.
Scene touching_cluster(const Boundaries& boundary, int columns, int rows, std::uint64_t seed) {
  RandomStream random = random_for(seed);
  Scene scene = in_box({columns + 3.0, rows + 2.5}, boundary);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      scene.disks.push_back(disk({column + 1.5, row + 1.25}, normal_velocity(random)));
    }
  }
  shuffle_ids(scene, random);
  return scene;
}

}  // namespace

GeneratedScenes symmetric() {
  GeneratedScenes scenes;
  for (const Boundaries& boundary : all_boundaries()) {
    const std::string where = name_of(boundary);
    scenes.push_back(
        {"four disks meet in the middle, " + where, realize(meeting_in_the_middle(boundary, false, false))});
    scenes.push_back(
        {"four disks meet one on the diagonals, " + where, realize(meeting_in_the_middle(boundary, true, true))});
    scenes.push_back({"disks at corners and seams, " + where, realize(corners_and_seams(boundary))});
  }
  for (const Boundary along : {Boundary::periodic, Boundary::reflecting, Boundary::open}) {
    for (const int axis : {0, 1}) {
      scenes.push_back({fmt::format("disk meets two copies at once, axis {}, {}", axis, carom::name_of(along)),
                        realize(between_copies(along, axis, 1))});
    }
  }
  return scenes;
}

GeneratedScenes touching() {
  GeneratedScenes scenes;
  std::uint64_t seed = 700;
  for (const Boundaries& boundary : all_boundaries()) {
    ++seed;
    const std::string where = name_of(boundary);
    const int axis = static_cast<int>(seed % 2);
    const int resting = 2 + static_cast<int>(seed % 7);
    scenes.push_back({fmt::format("cradle of {} disks along axis {}, {}", resting + 2, axis, where),
                      realize(cradle(boundary, axis, resting, 2))});
    scenes.push_back({"rack hit in the middle, " + where, realize(rack(boundary, 4, 0))});
    scenes.push_back({"inelastic rack hit off the middle, " + where, [&] {
                        Scene scene = rack(boundary, 5, 0.3);
                        scene.restitution = 0.9;
                        return realize(scene);
                      }()});
    scenes.push_back({"tolerated overlaps, " + where, realize(tolerated_overlaps(boundary, seed))});
    scenes.push_back({"touching cluster, " + where, realize(touching_cluster(boundary, 4, 3, seed))});
  }
  return scenes;
}

}  // namespace carom::test
