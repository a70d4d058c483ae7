// How a window's work is divided. Changes the speed and never a bit of the results.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace carom {

struct ParallelOptions {
  unsigned threads = 1;
  std::optional<std::array<std::uint32_t, 2>> patches = {};  ///< along x and y; chosen from the system by default
  // For tests: forced where above 0, else chosen from the flow and from how often patches had to be repaired.
  double near = 0;  ///< width of the strip of copies that are compared with their owners (length)
  double halo = 0;  ///< width of all copies around a patch (length)
};

/// What became of it.
struct Division {
  /// Where the time of divided windows went (seconds).
  struct Phases {
    double sort = 0;     ///< disks into bins
    double advance = 0;  ///< patches, repaired ones too
    double verify = 0;
    double collect = 0;  ///< sums and rows of the log
  };
  std::uint64_t threads = 1;
  std::uint64_t patches = 1;
  std::uint64_t windows_repaired = 0;  ///< windows in which a patch had to be advanced again
  std::uint64_t patches_repaired = 0;  ///< patches advanced again
  std::uint64_t patch_windows = 0;     ///< patches advanced in all
  double duplicated = 0;               ///< contacts computed beyond those that count, as a share of those
  Phases phases;
};

}  // namespace carom
