// What makes a system and its start impossible to simulate.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// Something wrong, and the disk it is about (the one with the larger id of a pair), if it is about one.
struct Finding {
  enum class About { disks, box, physics };

  std::string message;
  std::optional<std::size_t> disk;
  About about = About::disks;
};

/// Disks may overlap by this share of their contact distance (rounding of a file's digits), not more.
inline constexpr double kOverlapTolerance = 1e-9;

/// Everything that is wrong: no disks, numbers that are NaN, infinite or out of range, radii and masses ≤ 0,
/// restitution outside [0, 1], disks outside the box or overlapping (both named), a periodic box narrower than the
/// largest diameter. Empty if all is well. Lists at most 20 findings of one kind and says how many more there are.
std::vector<Finding> validate(const System& system, const Frame& frame);

}  // namespace carom
