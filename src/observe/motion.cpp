#include "motion.hpp"

namespace carom {

Vec2 drift_velocity(const System& system, const Frame& frame) noexcept {
  double mass = 0;
  for (std::size_t k = 0; k < frame.size(); ++k) mass += system.mass(k);
  const Vec2 mean = momentum(system, frame) / mass;
  return {system.box.conserves_momentum(0) ? mean.x : 0, system.box.conserves_momentum(1) ? mean.y : 0};
}

double mean_speed(const System& system, const Frame& frame) noexcept {
  const Vec2 drift = drift_velocity(system, frame);
  double sum = 0;
  for (std::size_t k = 0; k < frame.size(); ++k) sum += length(frame.velocity(k) - drift);
  return sum / static_cast<double>(frame.size());
}

}  // namespace carom
