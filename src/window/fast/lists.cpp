#include "lists.hpp"

#include <algorithm>
#include <cmath>

namespace carom::fast {

Lists::Lists(const System& system, const Extent& extent, double shell, double slack, const Array<Record>& records,
             const Array<DiskId>& ids, double time)
    : box_(system.box),
      records_(records),
      ids_(ids),
      shell_(shell),
      slack_(slack),
      leash_(shell / 2),
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
  for_neighbours(k, [&](const Neighbour& neighbour) { drop(neighbour.disk, k); });
  grid.remove(k, centre(k));
  clear(k);
  lists_[k].x = place.x;
  lists_[k].y = place.y;
  look_around(k, true);
  grid.insert(k, place);
}

void Lists::look_around(Index k, bool both_ways) {
  for (const Level& level : levels_) {
    if (level.largest_radius == 0) continue;
    Grid::Found found;
    const double reach = records_[k].radius + level.largest_radius + shell_ + slack_;
    if (!level.grid.find_near(centre(k), reach, found) || !take_near(k, reach, level.grid.far(), found, both_ways)) {
      look_around_at(level, k, reach, both_ways);
    }
  }
  if (near_wall(k)) lists_[k].traits |= List::kNearWall;
}

/// Enters those of the found disks that are near. Returns false, with nothing done, if one may lie beyond a seam.
bool Lists::take_near(Index k, double reach, Vec2 far, Grid::Found& found, bool both_ways) {
  const int size = one_radius_ ? keep_near<true>(k, reach, far, found) : keep_near<false>(k, reach, far, found);
  if (size < 0) return false;
  for (int m = 0; m < size; ++m) {
    add(k, {found.points[m], {}});
    if (both_ways) add(found.points[m], {k, {}});
  }
  return true;
}

/// Keeps those of the found disks that are near, and says how many; -1 if one may lie beyond a seam.
template <bool kOneRadius>
int Lists::keep_near(Index k, double reach, Vec2 far, Grid::Found& found) const {
  const Vec2 here = centre(k);
  const double radius = records_[k].radius;
  double farthest = 0;
  int size = 0;
  for (int m = 0; m < found.size; ++m) {
    const Index other = found.points[m];
    const Vec2 r = centre(other) - here;
    const double distance_squared = dot(r, r);
    const double range = kOneRadius ? reach : radius + records_[other].radius + shell_ + slack_;
    farthest = std::max(farthest, distance_squared);
    found.points[size] = other;  // kept if it is near, which cannot be guessed: no branch asks
    size += static_cast<int>(distance_squared < range * range) & static_cast<int>(other != k);
  }
  const double least = std::min(far.x, far.y);
  return farthest < least * least ? size : -1;
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
  List& list = lists_[k];
  if ((list.traits & List::kLong) != 0) {
    std::erase_if(long_[list.near[0]].neighbours, [disk](const Neighbour& other) { return other.disk == disk; });
    return;
  }
  int place = -1;
  for (int m = 0; m < List::kRoom; ++m) place = list.near[m] == disk ? m : place;
  if (place < 0) return;
  list.near[place] = list.near[--list.count];
  list.near[list.count] = k;
}

}  // namespace carom::fast
