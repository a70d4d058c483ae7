// A finished window played again, to see the disks at times inside it.
#pragma once

#include <cstddef>
#include <vector>

#include "carom/run/simulation.hpp"

namespace carom {

/// Frames at growing times inside a window, made from its start and its collisions: each disk flies freely to its next
/// contact, where its velocity changes by the impulse over its mass. Agrees with the run to rounding, and depends on
/// state and log alone. Valid while the record is; needs a window that comes with its collisions.
class WindowReplay {
 public:
  explicit WindowReplay(const WindowRecord& window);

  /// All disks at `time`, which lies in the window, having had the contacts before it; at the window's start, its bits.
  /// Valid until the next call.
  const Frame& at(double time);

 private:
  void carry(std::size_t disk, double offset) noexcept;
  void collide(const Collision& collision) noexcept;

  const WindowRecord& window_;
  std::size_t next_ = 0;  // collision
  // Per disk, at its last contact; positions are not wrapped.
  std::vector<Vec2> position_;
  std::vector<Vec2> velocity_;
  std::vector<double> since_;  // offset of that contact
  Frame frame_;
};

}  // namespace carom
