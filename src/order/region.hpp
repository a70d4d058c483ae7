// The rectangle that Voronoi cells fill, in whole steps of a fine grid, and the copies of disks around it.
#pragma once

#include <cstdint>
#include <vector>

#include "carom/base/vec2.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// A coordinate on the grid, and how many periods were taken off to bring it into the region.
struct Step {
  std::int32_t at = 0;
  double turns = 0;
};

/// A coordinate or a copy of it, in steps.
struct Copy {
  std::int32_t at = 0;
  double turns = 0;       ///< periods added, along a periodic axis
  bool mirrored = false;  ///< its image in a wall, or of an image
};

/// One axis of the rectangle, from 0 to `steps`. Periodic copies are whole periods away; at other ends the disks are
/// mirrored, so that cells end there: a point inside is nearer to a disk than to the disk's mirror image.
struct RegionAxis {
  double low = 0;
  double width = 0;  ///< length
  bool periodic = false;
  std::int64_t steps = 0;
  std::int64_t margin = 0;  ///< steps beyond both ends in which copies lie

  [[nodiscard]] double steps_per_length() const noexcept { return static_cast<double>(steps) / width; }
  [[nodiscard]] Step step_of(double coordinate) const noexcept;
  /// All copies in [−margin, steps + margin], the coordinate itself first.
  void copies_of(std::int32_t at, std::vector<Copy>& copies) const;
};

struct Region {
  RegionAxis x, y;
};

/// The box, but along open axes the disks with a margin around them. The caller guarantees at least one disk.
Region region_of(const System& system, const Frame& frame);

/// Chooses the grid so fine that a region with copies up to `margin` (length) around it just fits 32-bit integers.
/// Throws Error if there would be more than some copies per disk.
void lay_grid(Region& region, double margin, std::size_t disks);

}  // namespace carom
