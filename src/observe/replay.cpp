#include "carom/observe/replay.hpp"

namespace carom {

WindowReplay::WindowReplay(const WindowRecord& window) : window_(window) {
  const Frame& start = window.before.disks;
  since_.assign(start.size(), 0);
  for (std::size_t k = 0; k < start.size(); ++k) {
    position_.push_back(start.position(k));
    velocity_.push_back(start.velocity(k));
  }
  frame_ = start;
}

void WindowReplay::carry(std::size_t disk, double offset) noexcept {
  position_[disk] = position_[disk] + velocity_[disk] * (offset - since_[disk]);
  since_[disk] = offset;
}

void WindowReplay::collide(const Collision& collision) noexcept {
  const Vec2 impulse = collision.impulse * collision.normal;  // on the partner
  carry(collision.i, collision.time);
  velocity_[collision.i] = velocity_[collision.i] - impulse / window_.system.mass(collision.i);
  if (is_wall(collision.j)) return;
  carry(collision.j, collision.time);
  velocity_[collision.j] = velocity_[collision.j] + impulse / window_.system.mass(collision.j);
}

const Frame& WindowReplay::at(double time) {
  const double offset = time - window_.before.clock.start;
  const std::span<const Collision> collisions = window_.collisions;
  for (; next_ < collisions.size() && collisions[next_].time < offset; ++next_) collide(collisions[next_]);
  frame_.time = time;
  if (offset == 0) return frame_;  // as it was made

  const Frame& start = window_.before.disks;
  const Box& box = window_.system.box;
  for (std::size_t k = 0; k < frame_.size(); ++k) {
    const Vec2 now = position_[k] + velocity_[k] * (offset - since_[k]);
    const Wrapped x = box.periodic(0) ? wrap(now.x, box.size.x) : Wrapped{now.x, 0};
    const Wrapped y = box.periodic(1) ? wrap(now.y, box.size.y) : Wrapped{now.y, 0};
    frame_.x[k] = x.coordinate;
    frame_.y[k] = y.coordinate;
    frame_.winding_x[k] = start.winding_x[k] + x.turns;
    frame_.winding_y[k] = start.winding_y[k] + y.turns;
    frame_.vx[k] = velocity_[k].x;
    frame_.vy[k] = velocity_[k].y;
  }
  return frame_;
}

}  // namespace carom
