// What a scene says about running it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "carom/base/error.hpp"

namespace carom {

/// Which file format a trajectory is written in.
enum class TrajectoryFormat { none, xyz, h5md };

/// One [[observe]] section, or one name of --observe: an observable and what it is told.
struct ObserveSpec {
  std::string name;
  std::map<std::string, double> options = {};  ///< by key; which ones there are is the observable's to say
  std::map<std::string, Place> places = {};    ///< where the options were read, by key
  Place place = {};
};

/// The most collisions that a run can be told to end at: the largest integer of the files that tell it.
inline constexpr std::uint64_t kMostCollisions = INT64_MAX;

/// The [run] section of a scene; the command line's options of the same names take its place.
struct RunSettings {
  std::optional<double> until = {};              ///< simulate to this time
  std::optional<std::uint64_t> collisions = {};  ///< stop at the first window's end at or after so many collisions
  double equilibrate = 0;                        ///< pressure is measured from the first window after this time
  std::optional<double> every = {};              ///< time between frames of the trajectory
  TrajectoryFormat trajectory = TrajectoryFormat::none;
  std::vector<ObserveSpec> observe = {};
};

}  // namespace carom
