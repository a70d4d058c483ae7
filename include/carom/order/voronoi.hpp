// Voronoi cells: who is next to whom, and how much room each disk has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "carom/base/vec2.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// A disk, or a periodic image of one, whose Voronoi cell shares an edge with that of the disk looked at.
struct VoronoiNeighbour {
  std::uint32_t disk = 0;
  Vec2 r;           ///< from the disk looked at to this one, or to its image (length)
  double edge = 0;  ///< length of the shared edge
};

/// The cells of one frame. In a small periodic box a disk can neighbour several images of another, or of itself.
struct VoronoiCells {
  std::vector<std::size_t> first;            ///< N + 1 entries: where each disk's neighbours begin
  std::vector<VoronoiNeighbour> neighbours;  ///< of disk 0, then of disk 1, …; each disk's counter-clockwise
  std::vector<double> area;                  ///< of each disk's cell (length²)

  [[nodiscard]] std::size_t size() const noexcept { return area.size(); }
  [[nodiscard]] std::span<const VoronoiNeighbour> of(std::size_t k) const noexcept {
    return {neighbours.data() + first[k], first[k + 1] - first[k]};
  }
};

/// Voronoi cells of the centres. Cells end at reflecting walls; along an open axis they end at a margin around the
/// outermost disks, a tenth of the cluster's longer side. So the areas add up to that of the box (or of the cluster
/// with its margin), and what meets only beyond is not neighbours. Where four or more disks lie on a circle, as on a
/// square lattice, the diagonals are not neighbours: an edge counts only if it is longer than what coordinates are
/// rounded to here, some 1e-8 of the box. Throws Error if two centres are closer than that.
VoronoiCells voronoi_cells(const System& system, const Frame& frame);

}  // namespace carom
