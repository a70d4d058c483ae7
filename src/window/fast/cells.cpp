#include "cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace carom::fast {
namespace {

/// Fewer cells along a periodic axis, and one cell could be two neighbours of another.
constexpr double kFewestCells = 4;

/// Of the box, or of the part that is cut out.
double size_along(const Box& box, const Extent& extent, int axis) noexcept {
  const Vec2 size = extent.cut[axis] ? extent.high - extent.low : box.size;
  return axis == 0 ? size.x : size.y;
}

double largest_diameter(const System& system) noexcept {
  double radius = 0;
  for (const Species& kind : system.species) radius = std::max(radius, kind.radius);
  return 2 * radius;
}

}  // namespace

bool Cells::fit(const System& system, const Extent& extent, double slack) {
  const Box& box = system.box;
  const double least = largest_diameter(system) + slack;
  for (int axis = 0; axis < 2; ++axis) {
    if (box.boundary[axis] == Boundary::open && !extent.cut[axis]) return false;
    if (size_along(box, extent, axis) < kFewestCells * least) return false;
  }
  return true;
}

Cells::Cells(const System& system, const Extent& extent, double width, double slack, const Array<Record>& records,
             const Array<DiskId>& ids)
    : box_(system.box), records_(records), ids_(ids) {
  const Vec2 size{size_along(box_, extent, 0), size_along(box_, extent, 1)};
  const double least = largest_diameter(system) + slack;
  const double most = 8 * static_cast<double>(records.size()) + 64;
  width = std::max({width, least, std::sqrt(size.x / most * size.y)});
  const auto cells_along = [&](double length) {
    return static_cast<std::int32_t>(std::clamp(std::floor(length / width), kFewestCells, most));
  };
  columns_ = cells_along(size.x);
  rows_ = cells_along(size.y);
  width_ = {size.x / columns_, size.y / rows_};
  low_ = {extent.cut[0] ? extent.low.x : 0, extent.cut[1] ? extent.low.y : 0};
  for (int axis = 0; axis < 2; ++axis) {
    const double low = axis == 0 ? extent.low.x : extent.low.y;
    const double high = axis == 0 ? extent.high.x : extent.high.y;
    const double length = axis == 0 ? box_.size.x : box_.size.y;
    wraps_[axis] = box_.periodic(axis) && !extent.cut[axis];
    const auto edge = [&](bool at_wall) {
      if (wraps_[axis]) return Place::kPlain;
      return box_.reflecting(axis) && at_wall ? Place::kNearWall : Place::kAtCut;
    };
    edge_[axis] = {edge(!extent.cut[axis] || low <= 0), edge(!extent.cut[axis] || high >= length)};
  }
  // A row's three cells are read with one load that may reach beyond them.
  slots_.assign(static_cast<std::size_t>(number_of(columns_, rows_) + 1) * kSlots + 16, Slot::kEmpty);
  places_.resize(records.size());
  const auto cell_at = [](double x, double cell_width, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(x / cell_width, 0.0, static_cast<double>(count - 1)));
  };
  const Vec2 middle = low_ + 0.5 * size;
  for (Index k = 0; k < static_cast<Index>(records.size()); ++k) {
    Image turn;
    if (box_.periodic(0) && !wraps_[0]) {
      turn.x = static_cast<std::int32_t>(periods_from(records[k].x, middle.x, box_.size.x));
    }
    if (box_.periodic(1) && !wraps_[1]) {
      turn.y = static_cast<std::int32_t>(periods_from(records[k].y, middle.y, box_.size.y));
    }
    places_[k] = {
        .contact = predict::kNever,
        .partner = kNobody,
        .partner_events = 0,
        .column = cell_at(records[k].x - turn.x * box_.size.x - low_.x, width_.x, columns_),
        .row = cell_at(records[k].y - turn.y * box_.size.y - low_.y, width_.y, rows_),
        .cell = 0,
        .traits = Place::kPlain,
        .exit = 0,
    };
    if (turn != Image{}) set_turns(k, turn);
    note_edges(k);
    insert(k);
  }
}

void Cells::note_edges(Index k) noexcept {
  Place& place = places_[k];
  unsigned traits = place.traits & ~(Place::kNearWall | Place::kAtCut);
  if (place.column == 0) traits |= edge_[0][0];
  if (place.column == columns_ - 1) traits |= edge_[0][1];
  if (place.row == 0) traits |= edge_[1][0];
  if (place.row == rows_ - 1) traits |= edge_[1][1];
  place.traits = static_cast<std::uint8_t>(traits);
}

/// Writes disk k, or Slot::kEmpty, into a slot of a cell and of the copies of that cell in the border.
void Cells::write_slot(std::int32_t column, std::int32_t row, unsigned slot, Index k, bool crowded) noexcept {
  const Image turned = k >= 0 ? turns(k) : Image{};
  const auto write = [&](std::int32_t sx, std::int32_t sy) {
    slots(column + sx * columns_, row + sy * rows_)[slot] =
        k >= 0 ? Slot::of(k, {sx - turned.x, sy - turned.y}, crowded) : Slot::kEmpty;
  };
  write(0, 0);
  if (!is_outermost(column, row)) return;
  const std::int32_t sx = !wraps_[0] ? 0 : column == 0 ? 1 : column == columns_ - 1 ? -1 : 0;
  const std::int32_t sy = !wraps_[1] ? 0 : row == 0 ? 1 : row == rows_ - 1 ? -1 : 0;
  if (sx != 0) write(sx, 0);
  if (sy != 0) write(0, sy);
  if (sx != 0 && sy != 0) write(sx, sy);
}

/// Writes the slots of a cell anew, after something about its disks has changed.
void Cells::write_slots(std::int32_t column, std::int32_t row) noexcept {
  const bool crowded = surplus_.contains(number_of(column, row));
  for (unsigned m = 0; m < kSlots; ++m) {
    const Index slot = slots(column, row)[m];
    if (slot >= 0) write_slot(column, row, m, Slot::disk(slot), crowded);
  }
}

void Cells::insert(Index k) {
  Place& place = places_[k];
  place.cell = static_cast<std::int32_t>(number_of(place.column, place.row) * kSlots);
  const Index* cell = slots(place);
  unsigned empty = 0;
  for (unsigned m = 0; m < kSlots; ++m) empty |= static_cast<unsigned>(cell[m] < 0) << m;
  if (empty != 0) {
    write_slot(place.column, place.row, static_cast<unsigned>(std::countr_zero(empty)), k, false);
  } else {
    surplus_[number_of(place.column, place.row)].push_back(k);
    write_slots(place.column, place.row);
  }
}

void Cells::remove(Index k) {
  const Place& place = places_[k];
  const Index* cell = slots(place);
  unsigned here = 0;
  unsigned taken = 0;
  for (unsigned m = 0; m < kSlots; ++m) {
    taken += static_cast<unsigned>(cell[m] >= 0);
    here |= static_cast<unsigned>(cell[m] >= 0 && Slot::disk(cell[m]) == k) << m;
  }
  const auto slot = static_cast<unsigned>(std::countr_zero(here));
  if (here != 0) write_slot(place.column, place.row, slot, Slot::kEmpty, false);
  if (taken < kSlots || surplus_.empty()) return;
  const auto found = surplus_.find(number_of(place.column, place.row));
  if (found == surplus_.end()) return;
  std::vector<Index>& rest = found->second;
  if (here == 0) {
    rest.erase(std::find(rest.begin(), rest.end(), k));
  } else {
    write_slot(place.column, place.row, slot, rest.back(), true);
    rest.pop_back();
  }
  if (rest.empty()) surplus_.erase(found);
  write_slots(place.column, place.row);
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
    if (!wraps_[axis] && (v > 0 ? cell == count - 1 : cell == 0)) return predict::kNever;
    const double low = axis == 0 ? low_.x : low_.y;
    const double edge = low + width * (v > 0 ? cell + 1 : cell) + size * turn;
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
  note_edges(k);
  insert(k);
}

void Cells::fold(Index k, Image turned) {
  const Image before = turns(k);
  set_turns(k, {before.x - turned.x, before.y - turned.y});
  write_slots(places_[k].column, places_[k].row);
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
