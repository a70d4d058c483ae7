// Scenes that several tests use.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "carom/state/scene.hpp"

namespace carom::test {

/// A gas of diameter 1 and mass 1 in a square box.
inline Scene gas(std::uint64_t disks, double packing, Boundary boundary = Boundary::periodic, std::uint64_t seed = 1) {
  Scene scene;
  scene.boundary = {boundary, boundary};
  GasSpec spec;
  spec.count = disks;
  spec.packing_fraction = packing;
  spec.seed = seed;
  scene.gas.push_back(spec);
  return scene;
}

inline DiskSpec disk(Vec2 position, Vec2 velocity, double radius = 0.5, double mass = 1) {
  DiskSpec spec;
  spec.position = position;
  spec.velocity = velocity;
  spec.radius = radius;
  spec.mass = mass;
  return spec;
}

/// Explicit disks in a box.
inline Scene box_of(Vec2 size, Boundary along_x, Boundary along_y, std::initializer_list<DiskSpec> disks) {
  Scene scene;
  scene.size = size;
  scene.boundary = {along_x, along_y};
  scene.disks = disks;
  return scene;
}

}  // namespace carom::test
