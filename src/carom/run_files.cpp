#include "run_files.hpp"

#include <cmath>

namespace carom {

void CollisionLog::on_window(const WindowRecord& window) {
  csv_.append(window.collisions, window.before.clock.start);
  kept_ = csv_.size();
}

void CollisionLog::finish(const Simulation& simulation) {
  csv_.append(simulation.collisions_in_flight(), simulation.window_start().clock.start);
  csv_.close();
}

double FrameSchedule::next_time() const noexcept {
  const double time = static_cast<double>(writer_->length().frames) * every_;
  return until_ && std::abs(time - *until_) <= 1e-9 * every_ ? *until_ : time;
}

void FrameSchedule::write_if_due(const Simulation& simulation) {
  if (simulation.time() == next_time()) writer_->append(simulation.system(), simulation.frame());
}

void FrameSchedule::finish(bool interrupted) {
  if (interrupted && writer_->length().frames > kept_.frames) writer_->cut_to(kept_);
  writer_->close();
}

}  // namespace carom
