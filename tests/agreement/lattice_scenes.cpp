// Lattices: dense ones with random velocities, and ones that move so that many events happen at the same time.
#include <fmt/format.h>

#include "scene_makers.hpp"

namespace carom::test {
namespace {

constexpr double kRowHeight = 0.8660254037844386;  // √3/2

bool is_periodic(const Boundaries& boundary, int axis) { return boundary[axis] == Boundary::periodic; }

/// Velocities of disks that meet in pairs, three at a time, or all at once.
struct TiedMotion {
  const char* name;
  Vec2 (*velocity)(int column, int row);
};

constexpr std::array kTiedMotions{
    TiedMotion{"columns closing in threes",
               [](int column, int) -> Vec2 {
                 return {1.0 - column % 3, 0};
               }},
    TiedMotion{"rows closing in pairs",
               [](int, int row) -> Vec2 {
                 return {0, row % 2 == 0 ? 1.0 : -1.0};
               }},
    TiedMotion{"checkerboard on the diagonals",
               [](int column, int row) -> Vec2 {
                 return (column + row) % 2 == 0 ? Vec2{1, 1} : Vec2{-1, -1};
               }},
    TiedMotion{"all alike",
               [](int, int) -> Vec2 {
                 return {0.75, -0.5};
               }},
};

GeneratedScene dense(const Boundaries& boundary, const LatticeShape& shape, std::uint64_t seed) {
  RandomStream random = random_for(seed);
  Scene scene = triangular_lattice(shape, boundary, [&](int, int) { return normal_velocity(random); });
  shuffle_ids(scene, random);
  return {fmt::format("triangular lattice of {} x {}, spacing {}, {}", shape.columns, shape.rows, shape.spacing,
                      name_of(boundary)),
          realize(scene)};
}

}  // namespace

Scene triangular_lattice(const LatticeShape& shape, const Boundaries& boundary, const VelocityOf& velocity) {
  const double width = (is_periodic(boundary, 0) ? shape.columns : shape.columns - 0.5) * shape.spacing;
  const double height = (is_periodic(boundary, 1) ? shape.rows : shape.rows - 1) * kRowHeight * shape.spacing;
  Scene scene = in_box(
      {width + (is_periodic(boundary, 0) ? 0 : shape.spacing), height + (is_periodic(boundary, 1) ? 0 : shape.spacing)},
      boundary);
  for (int row = 0; row < shape.rows; ++row) {
    for (int column = 0; column < shape.columns; ++column) {
      const double x = (column + 0.5 + (row % 2 == 0 ? 0.0 : 0.5)) * shape.spacing;
      scene.disks.push_back(
          disk({is_periodic(boundary, 0) && x > width ? x - width : x, (0.5 + row * kRowHeight) * shape.spacing},
               velocity(column, row)));
    }
  }
  return scene;
}

Scene square_lattice(const LatticeShape& shape, const Boundaries& boundary, const VelocityOf& velocity) {
  Scene scene = in_box({shape.columns * shape.spacing, shape.rows * shape.spacing}, boundary);
  for (int row = 0; row < shape.rows; ++row) {
    for (int column = 0; column < shape.columns; ++column) {
      scene.disks.push_back(disk({(column + 0.5) * shape.spacing, (row + 0.5) * shape.spacing}, velocity(column, row)));
    }
  }
  return scene;
}

GeneratedScenes dense_lattices() {
  // Packing fractions π/(2√3 a²) = 0.80, 0.88, 0.905 for these spacings a, where the box is periodic.
  constexpr std::array kShapes{LatticeShape{6, 6, 1.0647}, LatticeShape{8, 10, 1.0152}, LatticeShape{5, 4, 1.00105},
                               LatticeShape{2, 2, 1.0152}};
  GeneratedScenes scenes;
  std::uint64_t seed = 100;
  for (const LatticeShape& shape : kShapes) {
    for (const Boundaries& boundary : all_boundaries()) scenes.push_back(dense(boundary, shape, ++seed));
  }
  return scenes;
}

GeneratedScenes tied_lattices() {
  GeneratedScenes scenes;
  std::uint64_t seed = 200;
  for (const TiedMotion& motion : kTiedMotions) {
    for (const Boundaries& boundary : all_boundaries()) {
      RandomStream random = random_for(++seed);
      const bool square = seed % 3 != 0;
      const LatticeShape shape = square ? LatticeShape{6, 6, 1.25} : LatticeShape{6, 4, 1.5};
      Scene scene = square ? square_lattice(shape, boundary, motion.velocity)
                           : triangular_lattice(shape, boundary, motion.velocity);
      if (seed % 2 == 0) shuffle_ids(scene, random);
      scenes.push_back(
          {fmt::format("{} lattice, {}, {}", square ? "square" : "triangular", motion.name, name_of(boundary)),
           realize(scene)});
    }
  }
  return scenes;
}

}  // namespace carom::test
