#include "cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace carom::fast {
namespace {

/// Fewer cells along a periodic axis, and one cell could be two neighbours of another.
constexpr double kFewestCells = 4;

double largest_diameter(const System& system) noexcept {
  double radius = 0;
  for (std::size_t k = 0; k < system.size(); ++k) radius = std::max(radius, system.radius(k));
  return 2 * radius;
}

}  // namespace

bool Cells::fit(const System& system, double slack) {
  const Box& box = system.box;
  if (box.boundary[0] == Boundary::open || box.boundary[1] == Boundary::open) return false;
  const double least = largest_diameter(system) + slack;
  return std::min(box.size.x, box.size.y) >= kFewestCells * least && system.size() < static_cast<std::size_t>(kMarked);
}

Cells::Cells(const System& system, double width, double slack, const Array<Record>& records, const Array<DiskId>& ids)
    : box_(system.box), records_(records), ids_(ids) {
  const double least = largest_diameter(system) + slack;
  const double most = 8 * static_cast<double>(records.size()) + 64;
  width = std::max(width, least);
  width = std::max(width, std::sqrt(box_.size.x / most * box_.size.y));
  const auto cells_along = [&](double size) {
    return static_cast<std::int32_t>(std::clamp(std::floor(size / width), kFewestCells, most));
  };
  columns_ = cells_along(box_.size.x);
  rows_ = cells_along(box_.size.y);
  width_ = {box_.size.x / columns_, box_.size.y / rows_};
  // A row's three cells are read with one load that may reach beyond them.
  slots_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) * kSlots + 16, kEmpty);
  places_.resize(records.size());
  const auto cell_at = [](double x, double cell_width, std::int32_t count) {
    return std::clamp(static_cast<std::int32_t>(x / cell_width), 0, count - 1);
  };
  for (Index k = 0; k < static_cast<Index>(records.size()); ++k) {
    places_[k] = {
        predict::kNever, kNobody, 0, cell_at(records[k].x, width_.x, columns_), cell_at(records[k].y, width_.y, rows_),
        Place::kPlain,   0};
    set_border(k);
    insert(k);
  }
}

void Cells::set_border(Index k) noexcept {
  Place& place = places_[k];
  const bool inside = place.column > 0 && place.column < columns_ - 1 && place.row > 0 && place.row < rows_ - 1;
  place.traits = static_cast<std::uint8_t>((place.traits & ~Place::kAtBorder) | (inside ? 0 : Place::kAtBorder));
}

void Cells::insert(Index k) {
  const std::ptrdiff_t cell = cell_of(k);
  Index* slots = slots_.data() + cell * kSlots;
  unsigned empty = 0;
  for (unsigned m = 0; m < kSlots; ++m) empty |= static_cast<unsigned>(slots[m] < 0) << m;
  if (empty == 0) {
    surplus_[cell].push_back(k);
    mark(cell);
    return;
  }
  const bool marked = (places_[k].traits & Place::kElsewhere) != 0;
  slots[std::countr_zero(empty)] = marked ? k | kMarked : k;
}

void Cells::remove(Index k) {
  const std::ptrdiff_t cell = cell_of(k);
  Index* slots = slots_.data() + cell * kSlots;
  unsigned here = 0;
  unsigned taken = 0;
  for (unsigned m = 0; m < kSlots; ++m) {
    taken += static_cast<unsigned>(slots[m] >= 0);
    here |= static_cast<unsigned>(slots[m] >= 0 && (slots[m] & ~kMarked) == k) << m;
  }
  if (here != 0) slots[std::countr_zero(here)] = kEmpty;
  if (taken < kSlots || surplus_.empty()) return;
  const auto found = surplus_.find(cell);
  if (found == surplus_.end()) return;
  std::vector<Index>& rest = found->second;
  if (here == 0) {
    rest.erase(std::find(rest.begin(), rest.end(), k));
  } else {
    slots[std::countr_zero(here)] = rest.back();
    rest.pop_back();
  }
  if (rest.empty()) surplus_.erase(found);
  mark(cell);
}

/// Marks the slots of a cell that need a closer look.
void Cells::mark(std::ptrdiff_t cell) noexcept {
  Index* slots = slots_.data() + cell * kSlots;
  const bool crowded = surplus_.contains(cell);
  for (int m = 0; m < kSlots; ++m) {
    if (slots[m] < 0) continue;
    const Index k = slots[m] & ~kMarked;
    slots[m] = crowded || (places_[k].traits & Place::kElsewhere) != 0 ? k | kMarked : k;
  }
}

void Cells::set_partner_image(Index k, Image image) {
  Place& place = places_[k];
  if (image == Image{}) {
    place.traits = static_cast<std::uint8_t>(place.traits & ~Place::kHasImage);
    return;
  }
  place.traits |= Place::kHasImage;
  partner_images_[k] = image;
}

double Cells::crossing_of_any(Index k) {
  Place& place = places_[k];
  const Record& own = records_[k];
  const Image turned = turns(k);
  const auto leave = [&](double x, double v, double width, std::int32_t cell, std::int32_t count, int axis,
                         std::int32_t turn) {
    const double size = axis == 0 ? box_.size.x : box_.size.y;
    if (v == 0) return predict::kNever;
    if (!box_.periodic(axis) && (v > 0 ? cell == count - 1 : cell == 0)) return predict::kNever;
    const double edge = width * (v > 0 ? cell + 1 : cell) + size * turn;
    return own.t + (edge - x) / v;
  };
  const double through_side = leave(own.x, own.vx, width_.x, place.column, columns_, 0, turned.x);
  const double through_top = leave(own.y, own.vy, width_.y, place.row, rows_, 1, turned.y);
  const bool sideways = through_side <= through_top;
  const Wall exit = sideways ? (own.vx > 0 ? Wall::right : Wall::left) : (own.vy > 0 ? Wall::top : Wall::bottom);
  place.exit = static_cast<std::uint8_t>(exit);
  return sideways ? through_side : through_top;
}

void Cells::cross(Index k) {
  Place& place = places_[k];
  remove(k);
  Image turn;
  switch (static_cast<Wall>(place.exit)) {
    case Wall::left: --place.column; break;
    case Wall::right: ++place.column; break;
    case Wall::bottom: --place.row; break;
    case Wall::top: ++place.row; break;
  }
  if (place.column < 0) turn.x = -1;
  if (place.column >= columns_) turn.x = 1;
  if (place.row < 0) turn.y = -1;
  if (place.row >= rows_) turn.y = 1;
  if (turn != Image{}) {
    place.column -= turn.x * columns_;
    place.row -= turn.y * rows_;
    const Image before = turns(k);
    set_turns(k, {before.x + turn.x, before.y + turn.y});
  }
  set_border(k);
  insert(k);
}

void Cells::fold(Index k, Image turned) {
  const Image before = turns(k);
  set_turns(k, {before.x - turned.x, before.y - turned.y});
  mark(cell_of(k));
}

void Cells::set_turns(Index k, Image turned) {
  Place& place = places_[k];
  if (turned == Image{}) {
    place.traits = static_cast<std::uint8_t>(place.traits & ~Place::kElsewhere);
    turns_.erase(k);
  } else {
    place.traits |= Place::kElsewhere;
    turns_[k] = turned;
  }
}

}  // namespace carom::fast
