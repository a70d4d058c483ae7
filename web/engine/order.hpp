// How well the neighbours of each disk stand in a hexagon.
#pragma once

#include <complex>
#include <vector>

#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom::page {

/// ψ6 of each disk: the mean of exp(6 i θ) over the directions θ to the disks within 1.5 times the spacing of a
/// triangular lattice of this density; 0 for a disk that has none. Copies across periodic seams count.
std::vector<std::complex<double>> hexatic_order(const System& system, const Frame& frame);

}  // namespace carom::page
