#include "lists.hpp"

#include <algorithm>
#include <cmath>

namespace carom::fast {
namespace {

/// The disks in these slots; how many there are, or -1 if a cell is full.
int disks_in(const Grid::Rows& rows, Index* disks) noexcept {
  int size = 0;
  int full = 0;
  const Index* row = rows.first;
  for (int b = 0; b < rows.rows; ++b, row += rows.stride) {
    for (int a = 0; a < rows.slots; a += Grid::kSlots) {
      for (int m = a; m < a + Grid::kSlots; ++m) {  // whether a slot is taken cannot be guessed: no branch asks
        disks[size] = row[m];
        size += static_cast<int>(row[m] >= 0);
      }
      full |= static_cast<int>(row[a + Grid::kSlots - 1] >= 0);
    }
  }
  return full == 0 ? size : -1;
}

/// ListSteps::find with a range of its own for every disk.
template <class RangeSquared>
int find_within(const Grid::Rows& rows, const List* lists, Index k, double far_squared, Index* found,
                RangeSquared range_squared) noexcept {
  const int candidates = disks_in(rows, found);
  double farthest = 0;
  int size = 0;
  for (int m = 0; m < candidates; ++m) {
    const Index other = found[m];
    const Vec2 r{lists[other].x - lists[k].x, lists[other].y - lists[k].y};
    const double distance_squared = dot(r, r);
    farthest = std::max(farthest, distance_squared);
    found[size] = other;  // kept if it is near, which cannot be guessed either
    size += static_cast<int>(distance_squared < range_squared(other)) & static_cast<int>(other != k);
  }
  return candidates < 0 || !(farthest < far_squared) ? -1 : size;
}

int find_plainly(const Grid::Rows& rows, const List* lists, Index k, double range_squared, double far_squared,
                 Index* found) {
  return find_within(rows, lists, k, far_squared, found, [=](Index) { return range_squared; });
}

int drop_plainly(List* lists, const Index* disks, int count, Index k) {
  for (int m = 0; m < count; ++m) {
    List& list = lists[disks[m]];
    if ((list.traits & List::kLong) != 0) return m;
    int place = -1;
    for (int n = 0; n < List::kRoom; ++n) place = list.near[n] == k ? n : place;
    if (place < 0) continue;
    list.near[place] = list.near[--list.count];
    list.near[list.count] = disks[m];
  }
  return count;
}

}  // namespace

ListSteps scalar_list_steps() noexcept { return {find_plainly, drop_plainly}; }

Lists::Lists(const System& system, const Extent& extent, double shell, double slack, const Array<Record>& records,
             const Array<DiskId>& ids, const ListSteps& steps, double time)
    : box_(system.box),
      records_(records),
      ids_(ids),
      shell_(shell),
      slack_(slack),
      leash_(shell / 2),
      steps_(steps),
      lists_(records.size()) {
  make_levels(system, extent);
  for (Index k = 0; k < static_cast<Index>(records.size()); ++k) {
    const Vec2 place = predict::position_at(records[k].flight(), time);
    lists_[k].x = place.x;
    lists_[k].y = place.y;
    lists_[k].traits = 0;
    clear(k);
    levels_[level_of(records[k].radius)].grid.insert(k, centre(k));
  }
  for (Index k = 0; k < static_cast<Index>(records.size()); ++k) look_around(k, false);
}

double Lists::mean_length() const noexcept {
  std::uint64_t neighbours = 0;
  for (Index k = 0; k < static_cast<Index>(lists_.size()); ++k) for_neighbours(k, [&](Neighbour) { ++neighbours; });
  return static_cast<double>(neighbours) / static_cast<double>(lists_.size());
}

/// Radii within a factor of two share a level.
std::size_t Lists::level_of(double radius) const noexcept {
  if (levels_.size() == 1) return 0;
  int exponent = 0;
  std::frexp(radius / smallest_radius_, &exponent);
  return std::min(static_cast<std::size_t>(std::max(exponent - 1, 0)), levels_.size() - 1);
}

void Lists::make_levels(const System& system, const Extent& extent) {
  constexpr std::size_t kMostLevels = 10;
  double largest = 0;
  smallest_radius_ = predict::kNever;
  for (const Record& record : records_) {
    smallest_radius_ = std::min(smallest_radius_, record.radius);
    largest = std::max(largest, record.radius);
  }
  one_radius_ = smallest_radius_ == largest;
  int exponent = 0;
  std::frexp(largest / smallest_radius_, &exponent);
  std::vector<std::size_t> disks(std::min(static_cast<std::size_t>(std::max(exponent, 1)), kMostLevels), 0);
  std::vector<double> radii(disks.size(), 0);
  for (std::size_t level = 0; level < disks.size(); ++level) {
    levels_.push_back({0, Grid(system.box, extent, predict::kNever, 1)});
  }
  for (const Record& record : records_) {
    const std::size_t level = level_of(record.radius);
    ++disks[level];
    radii[level] = std::max(radii[level], record.radius);
  }
  for (std::size_t level = 0; level < disks.size(); ++level) {
    const double width = 2 * radii[level] + shell_ + slack_;
    levels_[level] = {radii[level], Grid(system.box, extent, width, disks[level])};
  }
}

void Lists::renew(Index k, Vec2 place) {
  Grid& grid = levels_[level_of(records_[k].radius)].grid;
  drop_everywhere(k);
  if (!grid.in_same_cell(centre(k), place)) {
    grid.remove(k, centre(k));
    grid.insert(k, place);
  }
  clear(k);
  lists_[k].x = place.x;
  lists_[k].y = place.y;
  look_around(k, true);
}

/// Takes disk k out of the lists of its neighbours.
void Lists::drop_everywhere(Index k) {
  const List& list = lists_[k];
  if ((list.traits & List::kLong) != 0) {
    for (const Neighbour& neighbour : long_[list.near[0]].neighbours) drop(neighbour.disk, k);
    return;
  }
  for (int m = 0; m < list.count; ++m) {
    m += steps_.drop(lists_.data(), list.near.data() + m, list.count - m, k);
    if (m < list.count) drop(list.near[m], k);
  }
}

void Lists::look_around(Index k, bool both_ways) {
  for (const Level& level : levels_) {
    if (level.largest_radius == 0) continue;
    const double reach = records_[k].radius + level.largest_radius + shell_ + slack_;
    if (!take_near(k, reach, level.grid, both_ways)) look_around_at(level, k, reach, both_ways);
  }
  if (near_wall(k)) lists_[k].traits |= List::kNearWall;
}

/// Enters the disks of a level that are near. Returns false, with nothing done, if one may lie beyond a seam.
bool Lists::take_near(Index k, double reach, const Grid& grid, bool both_ways) {
  const Grid::Rows rows = grid.rows_near(centre(k), reach);
  if (rows.rows == 0) return false;
  std::array<Index, ListSteps::kRoom> found;
  const double least = std::min(grid.far().x, grid.far().y);
  const int size = one_radius_ ? steps_.find(rows, lists_.data(), k, reach * reach, least * least, found.data())
                               : find_of_any_size(rows, k, least * least, found.data());
  if (size < 0) return false;
  for (int m = 0; m < size; ++m) {
    add(k, {found[m], {}});
    if (both_ways) add(found[m], {k, {}});
  }
  return true;
}

/// As ListSteps::find, for disks of different sizes.
int Lists::find_of_any_size(const Grid::Rows& rows, Index k, double far_squared, Index* found) const {
  const double radius = records_[k].radius;
  return find_within(rows, lists_.data(), k, far_squared, found, [&](Index other) {
    const double range = radius + records_[other].radius + shell_ + slack_;
    return range * range;
  });
}

/// The same for any disks, copies too.
void Lists::look_around_at(const Level& level, Index k, double reach, bool both_ways) {
  const Vec2 here = centre(k);
  const double radius = records_[k].radius;
  level.grid.visit_near(
      here, reach, [&](Index other) { return centre(other); },
      [&](Index other, Image image) {
        Vec2 r = centre(other) - here;
        if (image != Image{}) r = r + Vec2{image.x * box_.size.x, image.y * box_.size.y};
        const double range = radius + records_[other].radius + shell_ + slack_;
        if (!(dot(r, r) < range * range) || other == k) return;
        if (image != Image{} && ids_[other] < ids_[k]) image = {-image.x, -image.y};
        add(k, {other, image});
        if (both_ways) add(other, {k, image});
      });
}

bool Lists::near_wall(Index k) const noexcept {
  if (!box_.has_walls()) return false;
  const double reach = records_[k].radius + leash_ + slack_;
  const Vec2 here = centre(k);
  return (box_.reflecting(0) && (here.x < reach || here.x > box_.size.x - reach)) ||
         (box_.reflecting(1) && (here.y < reach || here.y > box_.size.y - reach));
}

/// An empty list.
void Lists::clear(Index k) {
  List& list = lists_[k];
  if ((list.traits & List::kLong) != 0) {
    long_[list.near[0]].neighbours.clear();
    free_.push_back(list.near[0]);
  }
  list.count = 0;
  list.traits = 0;
  list.near.fill(k);
}

void Lists::add_to_long(Index k, Neighbour neighbour) {
  if ((lists_[k].traits & List::kLong) == 0) lengthen(k);
  long_[lists_[k].near[0]].neighbours.push_back(neighbour);
}

/// Moves the list to where there is room for any number of neighbours and for their images.
void Lists::lengthen(Index k) {
  List& list = lists_[k];
  Index place;
  if (free_.empty()) {
    place = static_cast<Index>(long_.size());
    long_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  Long& lengthened = long_[place];
  lengthened.partner_image = {};  // so far there was none but the disks themselves
  for (int m = 0; m < list.count; ++m) lengthened.neighbours.push_back({list.near[m], {}});
  list.count = 0;
  list.traits |= List::kLong;
  list.near[0] = place;
}

/// Takes every copy of `disk` out of the list of k.
void Lists::drop(Index k, Index disk) {
  if (steps_.drop(lists_.data(), &k, 1, disk) == 1) return;
  std::erase_if(long_[lists_[k].near[0]].neighbours, [disk](const Neighbour& other) { return other.disk == disk; });
}

}  // namespace carom::fast
