// What a scene says about running it.
#pragma once

#include <cstdint>
#include <optional>

namespace carom {

/// Which file format a trajectory is written in.
enum class TrajectoryFormat { none, xyz };

/// The [run] section of a scene; the command line's options of the same names take its place.
struct RunSettings {
  std::optional<double> until = {};              ///< simulate to this time
  std::optional<std::uint64_t> collisions = {};  ///< stop at the first window's end at or after so many collisions
  double equilibrate = 0;                        ///< pressure is measured from the first window after this time
  std::optional<double> every = {};              ///< time between frames of the trajectory
  TrajectoryFormat trajectory = TrajectoryFormat::none;
};

}  // namespace carom
