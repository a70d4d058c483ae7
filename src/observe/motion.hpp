// Velocities of a frame, relative to what is conserved.
#pragma once

#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// Mean velocity Σ m v / Σ m along axes that conserve momentum, 0 along the others: what temperature() leaves out.
Vec2 drift_velocity(const System& system, const Frame& frame) noexcept;

/// Mean of |v| relative to the drift.
double mean_speed(const System& system, const Frame& frame) noexcept;

}  // namespace carom
