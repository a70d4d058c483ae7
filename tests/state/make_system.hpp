// Systems and frames for tests, in few words.
#pragma once

#include <initializer_list>

#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

struct TestDisk {
  Vec2 position;
  double radius = 0.5;
  Vec2 velocity = {};
  double mass = 1;
};

/// A box with disks: what validate() and the sums over disks take.
struct TestSystem {
  System system;
  Frame frame;

  explicit TestSystem(Box box, std::initializer_list<TestDisk> disks = {}) {
    system.box = box;
    for (const TestDisk& disk : disks) add(disk);
  }
  void add(const TestDisk& disk) {
    system.add_disk({disk.radius, disk.mass});
    frame.add_disk(disk.position, disk.velocity);
  }
};

inline constexpr std::array kPeriodic{Boundary::periodic, Boundary::periodic};
inline constexpr std::array kReflecting{Boundary::reflecting, Boundary::reflecting};
inline constexpr std::array kOpen{Boundary::open, Boundary::open};
inline constexpr std::array kMixed{Boundary::periodic, Boundary::reflecting};

}  // namespace carom
