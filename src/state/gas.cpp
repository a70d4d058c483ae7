#include "carom/state/gas.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "carom/base/random.hpp"
#include "overlap_grid.hpp"

namespace carom {
namespace {

/// What a random stream is for; part of its key, so that no two uses share numbers.
enum Purpose : std::uint32_t { kVelocity = 1, kPlace = 2 };

constexpr int kMostMisses = 20'000;

/// A triangular lattice in the box: `rows` rows of `columns` sites, odd rows shifted by half a step.
struct Lattice {
  std::size_t rows = 1;
  std::size_t columns = 1;
  Vec2 origin;
  Vec2 step;
  Vec2 last;           ///< no site lies beyond: the walls less a radius
  double closest = 0;  ///< smallest distance of two sites; 0 if a disk does not fit between the walls

  [[nodiscard]] std::size_t sites() const noexcept { return rows * columns; }
  [[nodiscard]] Vec2 site(std::size_t index) const noexcept {
    const std::size_t row = index / columns;
    const double shift = row % 2 == 0 ? 0.0 : 0.5;
    return {std::min(origin.x + (static_cast<double>(index % columns) + shift) * step.x, last.x),
            std::min(origin.y + static_cast<double>(row) * step.y, last.y)};
  }
};

/// The lattice of so many rows and columns, stretched over the box as far as `radius` allows at walls.
Lattice stretch(const Box& box, std::size_t rows, std::size_t columns, double radius) {
  Lattice lattice{.rows = rows, .columns = columns, .origin = {}, .step = {}, .last = box.size, .closest = 0};
  const double across = static_cast<double>(columns);
  const double up = static_cast<double>(rows);
  const double shifted = rows > 1 ? 0.5 : 0.0;
  if (box.periodic(0)) {
    lattice.step.x = box.size.x / across;
    lattice.origin.x = 0.25 * lattice.step.x;
  } else {
    const double gaps = across - 1 + shifted;
    lattice.step.x = gaps > 0 ? (box.size.x - 2 * radius) / gaps : box.size.x;
    lattice.origin.x = gaps > 0 ? radius : 0.5 * box.size.x;
    lattice.last.x = box.size.x - radius;
  }
  if (box.periodic(1)) {
    lattice.step.y = box.size.y / up;
    lattice.origin.y = 0.5 * lattice.step.y;
  } else {
    lattice.step.y = rows > 1 ? (box.size.y - 2 * radius) / (up - 1) : box.size.y;
    lattice.origin.y = rows > 1 ? radius : 0.5 * box.size.y;
    lattice.last.y = box.size.y - radius;
  }
  if (lattice.last.x < radius || lattice.last.y < radius) return lattice;
  // Neighbours: in the row, one row up, and straight up two rows; an odd number of rows meets itself unshifted at a
  // seam.
  const double diagonal = length({0.5 * lattice.step.x, lattice.step.y});
  lattice.closest = columns > 1 || box.periodic(0) ? lattice.step.x : diagonal;
  if (rows > 1) lattice.closest = std::min({lattice.closest, diagonal, 2 * lattice.step.y});
  if (box.periodic(1) && rows % 2 == 1) lattice.closest = std::min(lattice.closest, lattice.step.y);
  return lattice;
}

bool overlaps_any(const OverlapGrid& grid, Vec2 position, double radius, std::span<const double> radius_of) {
  bool overlaps = false;
  grid.visit_near(position, radius, [&](std::size_t other, Vec2 r) {
    const double sigma = radius + radius_of[other];
    overlaps = overlaps || dot(r, r) < sigma * sigma;
  });
  return overlaps;
}

/// Finds out which places are free of obstacles.
class Obstacles {
 public:
  Obstacles(const Box& box, std::span<const Obstacle> obstacles, double radius, std::size_t count)
      : grid_(box, {{0, 0}, box.size}, radii_of(obstacles, radius), obstacles.size() + count) {
    for (const Obstacle& obstacle : obstacles) {
      grid_.insert(radius_of_.size(), obstacle.position, obstacle.radius);
      radius_of_.push_back(obstacle.radius);
    }
  }

  [[nodiscard]] std::vector<std::size_t> clear_sites(const Lattice& lattice, double radius) const {
    std::vector<std::size_t> clear;
    for (std::size_t index = 0; index < lattice.sites(); ++index) {
      if (!overlaps_any(grid_, lattice.site(index), radius, radius_of_)) clear.push_back(index);
    }
    return clear;
  }

 private:
  static OverlapGrid::Radii radii_of(std::span<const Obstacle> obstacles, double radius) {
    OverlapGrid::Radii radii{radius, radius};
    for (const Obstacle& obstacle : obstacles) {
      radii = {std::min(radii.smallest, obstacle.radius), std::max(radii.largest, obstacle.radius)};
    }
    return radii;
  }

  OverlapGrid grid_;
  std::vector<double> radius_of_;
};

/// For every number of rows the lattice with just enough sites, the loosest first.
std::vector<Lattice> candidate_lattices(const Box& box, std::size_t sites, double radius) {
  std::vector<Lattice> lattices;
  const double wanted = std::sqrt(static_cast<double>(sites) * (2 / std::sqrt(3.0)) * box.size.y / box.size.x);
  const auto most_rows = static_cast<std::size_t>(std::clamp(4 * wanted + 8, 1.0, static_cast<double>(sites) + 1));
  for (std::size_t rows = 1; rows <= most_rows; ++rows) {
    lattices.push_back(stretch(box, rows, (sites + rows - 1) / rows, radius));
  }
  std::stable_sort(lattices.begin(), lattices.end(),
                   [](const Lattice& a, const Lattice& b) { return a.closest > b.closest; });
  return lattices;
}

bool fits(const Lattice& lattice, double radius) noexcept { return lattice.closest >= 2 * radius; }

/// Largest factor for a radius that so many rows and columns allow. Walls take 2 r off the box, and the distances of
/// the stretched lattice shrink with them; solved for r where both meet.
double room_of(const Box& box, const Lattice& lattice, double radius) {
  double low = 0;
  double high = std::max(box.size.x, box.size.y) / radius;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    const bool has_room = fits(stretch(box, lattice.rows, lattice.columns, middle * radius), middle * radius);
    (has_room ? low : high) = middle;
  }
  return low;
}

std::vector<Vec2> spread(const Lattice& lattice, const std::vector<std::size_t>& clear, std::size_t count) {
  std::vector<Vec2> positions;
  positions.reserve(count);
  for (std::size_t k = 0; k < count; ++k) positions.push_back(lattice.site(clear[k * clear.size() / count]));
  return positions;
}

/// Region in which the centre of a disk may lie.
OverlapGrid::Extent room_for(const Box& box, double radius) {
  const double x = box.periodic(0) ? 0 : radius;
  const double y = box.periodic(1) ? 0 : radius;
  return {{x, y}, {box.size.x - x, box.size.y - y}};
}

/// Most disks, up to `count`, for which some lattice fits into the empty box.
std::size_t most_on_lattice(const Box& box, std::size_t count, double radius) {
  std::size_t fitting = 0;
  std::size_t refused = count + 1;
  while (refused - fitting > 1) {
    const std::size_t middle = fitting + (refused - fitting) / 2;
    (fits(candidate_lattices(box, middle, radius).front(), radius) ? fitting : refused) = middle;
  }
  return fitting;
}

std::vector<Vec2> spread_over_all(const Lattice& lattice, std::size_t count) {
  std::vector<std::size_t> all(lattice.sites());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return spread(lattice, all, count);
}

Placement place_in_empty_box(const Box& box, std::size_t count, double radius) {
  const std::vector<Lattice> lattices = candidate_lattices(box, count, radius);
  if (fits(lattices.front(), radius)) {
    return {spread_over_all(lattices.front(), count), room_of(box, lattices.front(), radius)};
  }
  Placement placement;
  for (const Lattice& lattice : lattices) placement.room = std::max(placement.room, room_of(box, lattice, radius));
  const std::size_t most = most_on_lattice(box, count, radius);
  if (most > 0) placement.positions = spread_over_all(candidate_lattices(box, most, radius).front(), most);
  return placement;
}

/// Obstacles take sites away: lattices with more and more sites are tried until enough of them are clear.
Placement place_around(const Box& box, std::size_t count, double radius, const Obstacles& obstacles) {
  Placement best;
  const std::size_t most_sites = most_on_lattice(box, 8 * count + 64, radius);
  for (std::size_t sites = count; sites <= most_sites;) {
    double share = 0;                        // of sites that are clear
    std::size_t tries = 4 + 20'000 / sites;  // the loosest few are enough where there are many sites
    for (const Lattice& lattice : candidate_lattices(box, sites, radius)) {
      if (!fits(lattice, radius) || tries-- == 0) break;
      const std::vector<std::size_t> clear = obstacles.clear_sites(lattice, radius);
      if (clear.size() >= count) return {spread(lattice, clear, count), 1};
      if (clear.size() > best.positions.size()) best = {spread(lattice, clear, clear.size()), 0};
      share = std::max(share, static_cast<double>(clear.size()) / static_cast<double>(lattice.sites()));
    }
    if (sites == most_sites) break;
    const auto likely = static_cast<std::size_t>(share > 0 ? 0.95 * static_cast<double>(count) / share : 0);
    sites = std::min(std::max(sites + 1 + sites / 64, likely), most_sites);
  }
  return best;
}

}  // namespace

Placement place_on_lattice(const Box& box, std::size_t count, double radius, std::span<const Obstacle> obstacles) {
  if (obstacles.empty()) return place_in_empty_box(box, count, radius);
  const Obstacles around(box, obstacles, radius, count);
  // What can be placed of too many must be what a caller who asks for just that many gets.
  std::size_t asked = most_on_lattice(box, count, radius);
  if (asked == 0) return {};
  Placement placement = place_around(box, asked, radius, around);
  while (placement.positions.size() < asked && !placement.positions.empty()) {
    asked = placement.positions.size();
    placement = place_around(box, asked, radius, around);
  }
  if (placement.positions.size() < count) placement.room = 0;
  return placement;
}

Placement place_at_random(const Box& box, std::span<const double> radii, std::uint64_t seed,
                          std::span<const Obstacle> obstacles) {
  std::vector<std::size_t> order(radii.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });

  std::vector<double> radius_of(radii.begin(), radii.end());
  OverlapGrid::Radii range{*std::min_element(radii.begin(), radii.end()),
                           *std::max_element(radii.begin(), radii.end())};
  for (const Obstacle& obstacle : obstacles) {
    range = {std::min(range.smallest, obstacle.radius), std::max(range.largest, obstacle.radius)};
  }
  OverlapGrid grid(box, {{0, 0}, box.size}, range, radii.size() + obstacles.size());
  for (const Obstacle& obstacle : obstacles) {
    grid.insert(radius_of.size(), obstacle.position, obstacle.radius);
    radius_of.push_back(obstacle.radius);
  }

  std::vector<Vec2> positions(radii.size());
  std::vector<Vec2> placed;
  for (const std::size_t k : order) {
    RandomStream random(seed, k, kPlace);
    const OverlapGrid::Extent room = room_for(box, radii[k]);
    bool found = false;
    for (int miss = 0; !found && miss < kMostMisses && room.low.x <= room.high.x && room.low.y <= room.high.y; ++miss) {
      const double across = random.uniform();
      const double up = random.uniform();
      positions[k] = {room.low.x + across * (room.high.x - room.low.x), room.low.y + up * (room.high.y - room.low.y)};
      found = !overlaps_any(grid, positions[k], radii[k], radius_of);
    }
    if (!found) return {std::move(placed), 0};
    grid.insert(k, positions[k], radii[k]);
    placed.push_back(positions[k]);
  }
  return {std::move(positions), 1};
}

void draw_velocities(const System& system, std::size_t first, std::span<const double> temperatures, std::uint64_t seed,
                     Frame& frame) {
  std::map<double, std::vector<std::size_t>> disks_at;
  for (std::size_t k = 0; k < temperatures.size(); ++k) disks_at[temperatures[k]].push_back(first + k);

  for (const auto& [kT, disks] : disks_at) {
    Vec2 total;
    double mass = 0;
    for (const std::size_t k : disks) {
      RandomStream random(seed, k, kVelocity);
      const double spread = std::sqrt(kT / system.mass(k));
      frame.vx[k] = spread * random.normal();
      frame.vy[k] = spread * random.normal();
      total = total + system.mass(k) * frame.velocity(k);
      mass += system.mass(k);
    }
    if (disks.size() == 1) continue;
    double twice_energy = 0;
    for (const std::size_t k : disks) {
      const Vec2 v = frame.velocity(k) - total / mass;
      frame.vx[k] = v.x;
      frame.vy[k] = v.y;
      twice_energy += system.mass(k) * dot(v, v);
    }
    const double share = degrees_of_freedom(system) / static_cast<double>(system.size());
    const double wanted = share * static_cast<double>(disks.size()) * kT;
    const double factor = twice_energy > 0 ? std::sqrt(wanted / twice_energy) : 0;
    for (const std::size_t k : disks) {
      frame.vx[k] *= factor;
      frame.vy[k] *= factor;
    }
  }
}

}  // namespace carom
