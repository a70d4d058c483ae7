// How each disk is surrounded: bond-orientational order, number of neighbours, local density.
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "carom/order/voronoi.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// Arrays of N, entry k belongs to disk k.
struct LocalOrder {
  /// ψ6 = (1/n) Σ exp(6iθ) over the n Voronoi neighbours, θ the angle of the line to each; 0 where there are none
  /// (Halperin and Nelson, Phys. Rev. Lett. 41, 121 (1978)). |ψ6| ≤ 1; its angle is six times that of the hexagon.
  std::vector<std::complex<double>> psi6;
  std::vector<std::uint32_t> neighbours;  ///< Voronoi neighbours, images counted singly
  std::vector<double> density;            ///< the disk's area over that of its Voronoi cell: a local packing fraction
};

/// Of one frame, under any boundary. Throws Error where voronoi_cells() does.
LocalOrder local_order(const System& system, const Frame& frame);

/// The same from cells already made.
LocalOrder local_order(const System& system, const VoronoiCells& cells);

}  // namespace carom
