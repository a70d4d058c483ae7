#include "carom/order/voronoi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>

#include "carom/base/error.hpp"
#include "region.hpp"

namespace carom {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using Edge = Diagram::edge_type;
using Cell = Diagram::cell_type;

// Shorter edges (in steps) can come from rounding the coordinates of disks on one circle.
constexpr double kShortestEdge = 16;

/// Width of the first strip of copies, in mean distances between disks: a little more than the diameter of the largest
/// empty circle among as many random points, √(4 ln N/π); enough unless there are holes.
double first_margin(std::size_t disks) { return 0.5 + std::sqrt(4 * (1 + std::log(static_cast<double>(disks))) / kPi); }

/// A point of the diagram: a disk, or a copy of one.
struct Site {
  std::uint32_t disk = 0;
  Vec2 turns;
  bool mirrored = false;
};

/// The diagram of all disks and of copies in a strip around them. Disk k is site k.
class Cells {
 public:
  Cells(const Frame& frame, const Region& region) : frame_(frame), region_(region) {
    boost::polygon::voronoi_builder<std::int32_t> builder;
    insert_sites(builder);
    builder.construct(&diagram_);
    find_cells();
  }

  /// Whether the strip was wide enough: no copy that was left out could have cut a corner off a disk's cell.
  [[nodiscard]] bool complete() const {
    for (std::size_t k = 0; k < cell_of_.size(); ++k) {
      const Edge* const first = cell_of_[k]->incident_edge();
      if (first == nullptr) return false;
      const Edge* edge = first;
      do {
        if (edge->is_infinite() || !covers_circle(*edge->vertex0(), site_of_disk_[k])) return false;
        edge = edge->next();
      } while (edge != first);
    }
    return true;
  }

  [[nodiscard]] VoronoiCells measured() const {
    VoronoiCells result;
    result.area.reserve(frame_.size());
    result.neighbours.reserve(6 * frame_.size());
    result.first.push_back(0);
    for (std::size_t k = 0; k < cell_of_.size(); ++k) {
      measure(k, result);
      result.first.push_back(result.neighbours.size());
    }
    return result;
  }

 private:
  template <class Builder>
  void insert_sites(Builder& builder) {
    const auto disks = static_cast<std::uint32_t>(frame_.size());
    for (std::uint32_t k = 0; k < disks; ++k) {
      const Step x = region_.x.step_of(frame_.x[k]);
      const Step y = region_.y.step_of(frame_.y[k]);
      builder.insert_point(x.at, y.at);
      sites_.push_back({k, {}, false});
      site_of_disk_.push_back({static_cast<double>(x.at), static_cast<double>(y.at)});
      turns_of_disk_.push_back({x.turns, y.turns});
    }
    std::vector<Copy> along_x;
    std::vector<Copy> along_y;
    for (std::uint32_t k = 0; k < disks; ++k) {
      region_.x.copies_of(static_cast<std::int32_t>(site_of_disk_[k].x), along_x);
      region_.y.copies_of(static_cast<std::int32_t>(site_of_disk_[k].y), along_y);
      for (std::size_t c = 1; c < along_x.size() * along_y.size(); ++c) {
        const Copy& x = along_x[c / along_y.size()];
        const Copy& y = along_y[c % along_y.size()];
        builder.insert_point(x.at, y.at);
        sites_.push_back({k, {x.turns, y.turns}, x.mirrored || y.mirrored});
      }
    }
  }

  void find_cells() {
    cell_of_.assign(frame_.size(), nullptr);
    for (const Cell& cell : diagram_.cells()) {
      if (cell.source_index() < cell_of_.size()) cell_of_[cell.source_index()] = &cell;
    }
    const auto lost = std::find(cell_of_.begin(), cell_of_.end(), nullptr);
    if (lost != cell_of_.end()) {
      throw Error(fmt::format("disk {} has no Voronoi cell: its centre is closer than {:.2g} to another",
                              lost - cell_of_.begin(), 1 / region_.x.steps_per_length()));
    }
  }

  /// The circle around a corner through the disk whose cell it belongs to is empty of sites; this tells whether it lies
  /// where all copies are.
  [[nodiscard]] bool covers_circle(const Diagram::vertex_type& corner, Vec2 site) const {
    const double radius = length(Vec2{corner.x(), corner.y()} - site);
    return covers(region_.x, corner.x(), radius) && covers(region_.y, corner.y(), radius);
  }
  static bool covers(const RegionAxis& axis, double centre, double radius) {
    return centre - radius >= -static_cast<double>(axis.margin) &&
           centre + radius <= static_cast<double>(axis.steps + axis.margin);
  }

  void measure(std::size_t k, VoronoiCells& result) const {
    const Vec2 scale{1 / region_.x.steps_per_length(), 1 / region_.y.steps_per_length()};
    const Vec2 centre = site_of_disk_[k];
    double twice_area = 0;
    const Edge* const first = cell_of_[k]->incident_edge();
    const Edge* edge = first;
    do {
      const Vec2 from = Vec2{edge->vertex0()->x(), edge->vertex0()->y()} - centre;
      const Vec2 to = Vec2{edge->vertex1()->x(), edge->vertex1()->y()} - centre;
      twice_area += cross(from, to);
      const Site& site = sites_[edge->twin()->cell()->source_index()];
      if (length(to - from) > kShortestEdge && !site.mirrored) {
        const Vec2 along = to - from;
        result.neighbours.push_back(
            {site.disk, separation(k, site), length(Vec2{along.x * scale.x, along.y * scale.y})});
      }
      edge = edge->next();
    } while (edge != first);
    result.area.push_back(0.5 * twice_area * scale.x * scale.y);
  }

  /// From the disks' own coordinates, which are finer than the grid.
  [[nodiscard]] Vec2 separation(std::size_t k, const Site& site) const {
    const Vec2 turns = site.turns - turns_of_disk_[site.disk] + turns_of_disk_[k];
    const Vec2 r = frame_.position(site.disk) - frame_.position(k);
    return {r.x + turns.x * region_.x.width, r.y + turns.y * region_.y.width};
  }

  const Frame& frame_;
  const Region& region_;
  Diagram diagram_;
  std::vector<Site> sites_;
  std::vector<Vec2> site_of_disk_;    // in steps
  std::vector<Vec2> turns_of_disk_;   // periods between a disk's coordinates and its site
  std::vector<const Cell*> cell_of_;  // of each disk
};

}  // namespace

VoronoiCells voronoi_cells(const System& system, const Frame& frame) {
  if (frame.size() == 0) return {{0}, {}, {}};
  Region region = region_of(system, frame);
  const double spacing = std::sqrt(region.x.width * region.y.width / static_cast<double>(frame.size()));
  double margin = first_margin(frame.size()) * spacing;
  for (;; margin *= 2) {
    lay_grid(region, margin, frame.size());
    const Cells cells(frame, region);
    if (cells.complete()) return cells.measured();
  }
}

}  // namespace carom
