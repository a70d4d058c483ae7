#include "carom/state/system.hpp"

#include <algorithm>
#include <bit>

namespace carom {

std::string_view name_of(Boundary boundary) noexcept {
  switch (boundary) {
    case Boundary::periodic: return "periodic";
    case Boundary::reflecting: return "reflecting";
    case Boundary::open: return "open";
  }
  return "";
}

double System::largest_radius() const noexcept {
  double largest = 0;
  for (const Species& kind : species) largest = std::max(largest, kind.radius);
  return largest;
}

void System::add_disk(const Species& kind) {
  const auto next = static_cast<std::uint32_t>(species.size());
  const auto [entry, is_new] = index_of_kind_.try_emplace(
      {std::bit_cast<std::uint64_t>(kind.radius), std::bit_cast<std::uint64_t>(kind.mass)}, next);
  if (is_new) species.push_back(kind);
  species_of.push_back(entry->second);
}

double packing_fraction(const System& system) noexcept {
  const double area = system.box.size.x * system.box.size.y;
  if (!(area > 0)) return 0;
  double covered = 0;
  for (std::size_t k = 0; k < system.size(); ++k) covered += system.radius(k) * system.radius(k);
  return kPi * covered / area;
}

}  // namespace carom
