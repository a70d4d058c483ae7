// Property: Voronoi cells fill the box without gap or overlap; neighbours are those of an independent construction.
#include "carom/order/voronoi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "arrangements.hpp"
#include "carom/base/error.hpp"

namespace carom {
namespace {

double total_area(const VoronoiCells& cells) { return std::accumulate(cells.area.begin(), cells.area.end(), 0.0); }

/// A cell cut out of a large square by the bisectors to all disks and images, one by one: O(N²).
struct CutCell {
  std::vector<Vec2> corners;
  std::vector<std::pair<std::uint32_t, Vec2>> owner;  // of the edge that starts at each corner; kNobody for walls

  static constexpr std::uint32_t kNobody = 0xffffffff;

  /// Keeps what is nearer to 0 than to r.
  void cut(std::uint32_t id, Vec2 r) {
    const double half = 0.5 * dot(r, r);
    CutCell rest;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec2 a = corners[k];
      const Vec2 b = corners[(k + 1) % corners.size()];
      const double outside_a = dot(a, r) - half;
      const double outside_b = dot(b, r) - half;
      if (outside_a <= 0) {
        rest.corners.push_back(a);
        rest.owner.push_back(owner[k]);
      }
      if ((outside_a <= 0) == (outside_b <= 0)) continue;
      rest.corners.push_back(a + outside_a / (outside_a - outside_b) * (b - a));
      rest.owner.push_back(outside_a <= 0 ? std::pair(id, r) : owner[k]);
    }
    *this = rest;
  }

  [[nodiscard]] double area() const {
    double twice = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) twice += cross(corners[k], corners[(k + 1) % corners.size()]);
    return twice / 2;
  }
};

CutCell cut_cell(const Arrangement& points, std::size_t k) {
  const Box& box = points.system.box;
  const Vec2 at = points.frame.position(k);
  Vec2 low = -at;
  Vec2 high = box.size - at;
  if (box.periodic(0)) low.x = -box.size.x, high.x = box.size.x;
  if (box.periodic(1)) low.y = -box.size.y, high.y = box.size.y;
  CutCell cell{{low, {high.x, low.y}, high, {low.x, high.y}}, {}};
  cell.owner.assign(4, {CutCell::kNobody, {}});
  const int images_x = box.periodic(0) ? 2 : 0;
  const int images_y = box.periodic(1) ? 2 : 0;
  for (std::size_t j = 0; j < points.frame.size(); ++j) {
    for (int nx = -images_x; nx <= images_x; ++nx) {
      for (int ny = -images_y; ny <= images_y; ++ny) {
        if (j == k && nx == 0 && ny == 0) continue;
        const Vec2 r = points.frame.position(j) - at + Vec2{nx * box.size.x, ny * box.size.y};
        cell.cut(static_cast<std::uint32_t>(j), r);
      }
    }
  }
  return cell;
}

using Bond = std::tuple<std::uint32_t, double, double, double>;  // disk, r, length of the edge

std::vector<Bond> bonds_of(const VoronoiCells& cells, std::size_t k) {
  std::vector<Bond> bonds;
  for (const VoronoiNeighbour& n : cells.of(k)) bonds.emplace_back(n.disk, n.r.x, n.r.y, n.edge);
  std::sort(bonds.begin(), bonds.end());
  return bonds;
}

std::vector<Bond> bonds_of(const CutCell& cell) {
  std::vector<Bond> bonds;
  for (std::size_t k = 0; k < cell.corners.size(); ++k) {
    const double edge = length(cell.corners[(k + 1) % cell.corners.size()] - cell.corners[k]);
    if (cell.owner[k].first == CutCell::kNobody || edge < 1e-7) continue;
    bonds.emplace_back(cell.owner[k].first, cell.owner[k].second.x, cell.owner[k].second.y, edge);
  }
  std::sort(bonds.begin(), bonds.end());
  return bonds;
}

void expect_like_cut_cells(const Arrangement& points) {
  const VoronoiCells cells = voronoi_cells(points.system, points.frame);
  ASSERT_EQ(cells.size(), points.frame.size());
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const CutCell cut = cut_cell(points, k);
    EXPECT_NEAR(cells.area[k], cut.area(), 3e-8 * points.system.box.size.x * points.system.box.size.y);
    const std::vector<Bond> found = bonds_of(cells, k);
    const std::vector<Bond> wanted = bonds_of(cut);
    ASSERT_EQ(found.size(), wanted.size()) << "disk " << k << " of " << cells.size();
    for (std::size_t b = 0; b < found.size(); ++b) {
      EXPECT_EQ(std::get<0>(found[b]), std::get<0>(wanted[b]));
      EXPECT_NEAR(std::get<1>(found[b]), std::get<1>(wanted[b]), 1e-12);
      EXPECT_NEAR(std::get<2>(found[b]), std::get<2>(wanted[b]), 1e-12);
      EXPECT_NEAR(std::get<3>(found[b]), std::get<3>(wanted[b]), 1e-6 * points.system.box.size.x);
    }
  }
}

TEST(Voronoi, CellsAreThoseCutOutOneByOne) {
  for (const auto& boundary : {kPeriodic, kReflecting, kMixed}) {
    for (const std::size_t count : {1, 2, 3, 5, 20, 100}) {
      SCOPED_TRACE(count);
      expect_like_cut_cells(random_points(count, {3, 2}, 11 + count, boundary));
    }
  }
}

TEST(Voronoi, AStripTooNarrowForAHoleIsWidened) {
  Arrangement points({10, 10});
  RandomStream random(5, 0, 0);
  for (int k = 0; k < 60; ++k) {  // all in a corner: the rest of the box is one hole
    const double x = random.uniform();
    points.add({x, random.uniform()});
  }
  expect_like_cut_cells(points);
}

TEST(Voronoi, AreasAddUpToTheBox) {
  for (const auto& boundary : {kPeriodic, kReflecting, kMixed}) {
    const Arrangement points = random_points(3000, {30, 20}, 7, boundary);
    EXPECT_NEAR(total_area(voronoi_cells(points.system, points.frame)), 600, 600 * 1e-12);
  }
}

TEST(Voronoi, RandomPointsHaveSixNeighboursOnAverage) {
  const Arrangement points = random_points(3000, {30, 20}, 8);
  EXPECT_EQ(voronoi_cells(points.system, points.frame).neighbours.size(), 6 * 3000U) << "Euler's formula on a torus";
}

TEST(Voronoi, NeighboursAreMutual) {
  const Arrangement points = random_points(500, {5, 8}, 9, kMixed);
  const VoronoiCells cells = voronoi_cells(points.system, points.frame);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    for (const VoronoiNeighbour& n : cells.of(k)) {
      const auto back = cells.of(n.disk);
      EXPECT_TRUE(std::any_of(back.begin(), back.end(), [&](const VoronoiNeighbour& other) {
        return other.disk == k && length(other.r + n.r) < 1e-12 && std::abs(other.edge - n.edge) < 1e-9;
      }));
    }
  }
}

TEST(Voronoi, SquareLatticesHaveFourNeighboursInAnyBox) {
  for (const double spacing : {1.0, 0.1, 1 / 3.0, 12345.6789}) {
    const Arrangement lattice = square_lattice(17, spacing);
    const VoronoiCells cells = voronoi_cells(lattice.system, lattice.frame);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      EXPECT_EQ(cells.of(k).size(), 4U);
      EXPECT_NEAR(cells.area[k] / (spacing * spacing), 1, 1e-6);
    }
  }
}

TEST(Voronoi, ATurnedSquareLatticeHasNoDiagonals) {
  for (const double spacing : {1.0, 1 / 7.0, 0.3}) {
    // Multiples of the lattice vector (4, 3)/5 are all 25 sites in a box of side 5.
    const double side = 5 * spacing;
    Arrangement lattice({side, side});
    for (int i = 0; i < 25; ++i) {
      lattice.add({wrap(0.8 * i * spacing, side).coordinate, wrap(0.6 * i * spacing, side).coordinate});
    }
    const VoronoiCells cells = voronoi_cells(lattice.system, lattice.frame);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      ASSERT_EQ(cells.of(k).size(), 4U);
      for (const VoronoiNeighbour& n : cells.of(k)) EXPECT_NEAR(length(n.r), spacing, 1e-12);
    }
  }
}

TEST(Voronoi, OpenClustersEndAtAMargin) {
  const Arrangement lattice = square_lattice(6, 1, kOpen);
  const VoronoiCells cells = voronoi_cells(lattice.system, lattice.frame);
  EXPECT_EQ(cells.of(0).size(), 2U);
  EXPECT_EQ(cells.of(1).size(), 3U);
  EXPECT_EQ(cells.of(7).size(), 4U);
  EXPECT_NEAR(total_area(cells), std::pow(5 + 2 * (0.1 * 5 + 0.4), 2), 1e-6);
}

TEST(Voronoi, AFewDisksFarApartInTheOpen) {
  Arrangement two({0, 0}, kOpen);
  two.add({0, 0}, 0.5);
  two.add({1e9, 3}, 0.5);
  const VoronoiCells cells = voronoi_cells(two.system, two.frame);
  ASSERT_EQ(cells.of(0).size(), 1U);
  EXPECT_EQ(cells.of(0)[0].r, (Vec2{1e9, 3}));

  Arrangement one({0, 0}, kOpen);
  one.add({7, 7}, 0.5);
  EXPECT_EQ(voronoi_cells(one.system, one.frame).neighbours.size(), 0U);
}

TEST(Voronoi, DisksOnASeamHaveTheirNeighboursBeyondIt) {
  Arrangement points({4, 4});
  for (const double x : {0.0, 1.0, 2.0, 3.0}) {
    for (const double y : {0.0, 1.0, 2.0, std::nextafter(3.0, 0.0)}) points.add({x, y});
  }
  points.frame.x[0] = std::nextafter(4.0, 0.0);  // rounds to the seam
  points.frame.y[1] = -1e-15;
  points.frame.y[1] += 1;
  const VoronoiCells cells = voronoi_cells(points.system, points.frame);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    ASSERT_EQ(cells.of(k).size(), 4U);
    for (const VoronoiNeighbour& n : cells.of(k)) EXPECT_NEAR(length(n.r), 1, 1e-12);
  }
}

TEST(Voronoi, CoincidingCentresAreAnError) {
  Arrangement points = random_points(20, {1, 1}, 3);
  points.add(points.frame.position(4));
  EXPECT_THROW((void)voronoi_cells(points.system, points.frame), Error);
}

TEST(Voronoi, NoDisksNoCells) {
  const Arrangement none({1, 1});
  EXPECT_EQ(voronoi_cells(none.system, none.frame).size(), 0U);
}

}  // namespace
}  // namespace carom
