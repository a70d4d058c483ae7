#include "carom/run/exhaustion.hpp"

#include <cmath>

#include "carom/predict/contact.hpp"

namespace carom {
namespace {

bool nothing_moves(const Frame& frame) noexcept {
  for (std::size_t k = 0; k < frame.size(); ++k) {
    if (!(frame.velocity(k) == Vec2{})) return false;
  }
  return true;
}

/// Along one axis: are two disks within sigma now, or on their way there?
bool come_near(double distance, double velocity, double sigma) noexcept {
  return std::abs(distance) <= sigma || distance * velocity < 0;
}

bool may_meet(const System& system, const Frame& frame, std::size_t i, std::size_t j) noexcept {
  const Vec2 r = frame.position(j) - frame.position(i);
  const Vec2 v = frame.velocity(j) - frame.velocity(i);
  const double sigma = system.radius(i) + system.radius(j);
  const bool open_x = system.box.boundary[0] == Boundary::open;
  const bool open_y = system.box.boundary[1] == Boundary::open;
  if (open_x && open_y) {
    const predict::Flight a{frame.position(i), frame.velocity(i), 0};
    const predict::Flight b{frame.position(j), frame.velocity(j), 0};
    return predict::contact_of_disks(a, b, {}, sigma) < predict::kNever;
  }
  return open_x ? come_near(r.x, v.x, sigma) : come_near(r.y, v.y, sigma);
}

}  // namespace

bool collisions_are_over(const System& system, const Frame& frame) noexcept {
  if (system.size() < 2 || nothing_moves(frame)) return true;
  const Box& box = system.box;
  if (box.boundary[0] != Boundary::open && box.boundary[1] != Boundary::open) return false;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    for (std::size_t j = i + 1; j < frame.size(); ++j) {
      if (may_meet(system, frame, i, j)) return false;
    }
  }
  return true;
}

}  // namespace carom
