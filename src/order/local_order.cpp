#include "carom/order/local_order.hpp"

#include <cstddef>

namespace carom {
namespace {

/// exp(6iθ) of a vector at angle θ, without trigonometry.
std::complex<double> sixfold(Vec2 r) noexcept {
  const Vec2 unit = r / length(r);
  const std::complex<double> once(unit.x, unit.y);
  const std::complex<double> cubed = once * once * once;
  return cubed * cubed;
}

}  // namespace

LocalOrder local_order(const System& system, const VoronoiCells& cells) {
  LocalOrder order;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    std::complex<double> sum = 0;
    for (const VoronoiNeighbour& neighbour : cells.of(k)) sum += sixfold(neighbour.r);
    const std::size_t count = cells.of(k).size();
    const double radius = system.radius(k);
    order.psi6.push_back(count > 0 ? sum / static_cast<double>(count) : 0);
    order.neighbours.push_back(static_cast<std::uint32_t>(count));
    order.density.push_back(kPi * radius * radius / cells.area[k]);
  }
  return order;
}

LocalOrder local_order(const System& system, const Frame& frame) {
  return local_order(system, voronoi_cells(system, frame));
}

}  // namespace carom
