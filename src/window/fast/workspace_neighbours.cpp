// Workspace: which neighbourhood serves the disks, and how wide its cells or lists are.
#include <algorithm>
#include <cmath>

#include "workspace.hpp"

namespace carom::fast {

Extent Workspace::extent(double time) const noexcept {
  Vec2 low{predict::kNever, predict::kNever};
  Vec2 high{-predict::kNever, -predict::kNever};
  for (const Record& own : records) {
    const Vec2 place = predict::position_at(own.flight(), time);
    low = {std::min(low.x, place.x), std::min(low.y, place.y)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y)};
  }
  return {low, high};
}

/// A length that no rounding of a position reaches in this window, however the disks may share their energy.
double Workspace::rounding_slack(const Extent& extent) const noexcept {
  double energy = 0;
  double least_mass = predict::kNever;
  for (std::size_t k = 0; k < records.size(); ++k) {
    const double m = mass(static_cast<Index>(k));
    energy += 0.5 * m * (records[k].vx * records[k].vx + records[k].vy * records[k].vy);
    least_mass = std::min(least_mass, m);
  }
  const double fastest = std::sqrt(2 * energy / least_mass);
  const double farthest = std::max({std::abs(extent.low.x), std::abs(extent.low.y), std::abs(extent.high.x),
                                    std::abs(extent.high.y), system.box.size.x, system.box.size.y});
  return 0x1p-44 * (farthest + fastest * length + records[0].radius);
}

/// How far lists should reach beyond contact: so far that they hold some kDisks disks where the disks are.
double Workspace::default_shell(const Extent& extent) const noexcept {
  constexpr double kDisks = 7.5;
  double diameters = 0;
  for (const Record& own : records) diameters += 2 * own.radius;
  const auto count = static_cast<double>(records.size());
  const double diameter = diameters / count;
  Extent occupied = extent;
  occupied.high = occupied.high + Vec2{diameter, diameter};
  const Vec2 size = size_of(occupied);
  const double reach = std::sqrt(kDisks * size.x * size.y / (count * kPi));
  return std::clamp(reach - diameter, 0.1 * diameter, 8 * diameter);
}

/// Of the box; along axes that are open or cut, of the part that the disks are in.
Vec2 Workspace::size_of(const Extent& range) const noexcept {
  const auto whole = [&](int axis) { return system.box.boundary[axis] != Boundary::open && !range.cut[axis]; };
  return {whole(0) ? system.box.size.x : range.high.x - range.low.x,
          whole(1) ? system.box.size.y : range.high.y - range.low.y};
}

void Workspace::find_neighbours() {
  const Extent range = part_ ? *part_ : extent(0);
  slack_ = 4 * rounding_slack(range);  // with some room for the windows to come
  if (chooses_cells(range)) {
    const double width = options_.cell_size > 0 ? options_.cell_size : default_cell_size(range);
    cells = std::make_unique<Cells>(system, range, width, 2 * slack_, records, ids);
  } else {
    build_lists(range);
  }
}

/// Lists where the disks are dense or of very different sizes, and where the box is not made for cells.
bool Workspace::chooses_cells(const Extent& range) const {
  constexpr double kDensest = 0.65;         // packing fraction from which on lists were measured to be faster
  constexpr double kWidestSizeRatio = 2.5;  // a cell is as wide as the largest disk
  if (records.size() >= static_cast<std::size_t>(Slot::kMostDisks)) return false;
  if (!Cells::fit(system, range, 2 * slack_)) return false;
  if (options_.neighbourhood) return *options_.neighbourhood == Neighbourhood::cells;
  double smallest = predict::kNever;
  double largest = 0;
  for (const Record& own : records) {
    smallest = std::min(smallest, own.radius);
    largest = std::max(largest, own.radius);
  }
  return largest <= kWidestSizeRatio * smallest && packing_fraction_ < kDensest;
}

/// So wide that a cell holds about kDisks disks.
double Workspace::default_cell_size(const Extent& range) const noexcept {
  constexpr double kDisks = 0.8;
  const Vec2 size = size_of(range);
  return std::sqrt(kDisks * size.x / static_cast<double>(records.size()) * size.y);
}

void Workspace::build_lists(const Extent& range) {
  constexpr double kTooMany = 20;
  const double least = 4 * slack_;
  double shell = std::max(options_.shell > 0 ? options_.shell : default_shell(range), least);
  lists = std::make_unique<Lists>(system, range, shell, slack_, records, ids, list_steps_);
  // Where the disks crowd in a part of the plane, the mean density said too little.
  while (options_.shell == 0 && shell / 2 >= least && shell > 0.2 * records[0].radius &&
         lists->mean_length() > kTooMany) {
    shell /= 2;
    lists = std::make_unique<Lists>(system, range, shell, slack_, records, ids, list_steps_);
  }
}

/// Lists that reach farther than half a periodic box would hold many copies of each disk.
double Workspace::widest_shell() const noexcept {
  double widest = predict::kNever;
  if (system.box.periodic(0)) widest = std::min(widest, system.box.size.x / 2);
  if (system.box.periodic(1)) widest = std::min(widest, system.box.size.y / 2);
  return widest;
}

void Workspace::widen_lists(double time) {
  renewals_now_ = 0;
  const double shell = 2 * lists->shell();
  if (shell > widest_shell()) return;
  lists =
      std::make_unique<Lists>(system, part_ ? *part_ : extent(time), shell, slack_, records, ids, list_steps_, time);
  predicted = false;
  first_unpredicted = 0;
  if (!patched) return;
  // From here on the disks go about around new centres, and farther.
  for (Index k = 0; k < static_cast<Index>(records.size()); ++k) note_excursion(k, time);
}

}  // namespace carom::fast
