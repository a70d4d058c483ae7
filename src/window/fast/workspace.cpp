#include "workspace.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "carom/base/simd.hpp"
#include "loops.hpp"

namespace carom::fast {
namespace {

constexpr double kEventsPerBucket = 7;

/// Bits of a number below 2¹⁶, one apart.
std::uint32_t spread_bits(std::uint32_t number) noexcept {
  number = (number | (number << 8)) & 0x00FF00FFU;
  number = (number | (number << 4)) & 0x0F0F0F0FU;
  number = (number | (number << 2)) & 0x33333333U;
  return (number | (number << 1)) & 0x55555555U;
}

/// The disks along a curve that keeps neighbours together (G. M. Morton, 1966), over squares of about two disks.
std::vector<DiskId> in_spatial_order(const Frame& disks, const Extent& extent) {
  const std::size_t count = disks.size();
  const double across = std::max({extent.high.x - extent.low.x, extent.high.y - extent.low.y, 1e-300});
  const double squares = std::clamp(std::sqrt(static_cast<double>(count) / 2), 1.0, 65535.0) / across;
  std::vector<std::pair<std::uint32_t, DiskId>> places(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto column = static_cast<std::uint32_t>((disks.x[k] - extent.low.x) * squares);
    const auto row = static_cast<std::uint32_t>((disks.y[k] - extent.low.y) * squares);
    places[k] = {spread_bits(column) | (spread_bits(row) << 1), static_cast<DiskId>(k)};
  }
  std::sort(places.begin(), places.end());
  std::vector<DiskId> order(count);
  std::transform(places.begin(), places.end(), order.begin(), [](const auto& place) { return place.second; });
  return order;
}

Extent extent_of(const Frame& disks) noexcept {
  const auto [low_x, high_x] = std::minmax_element(disks.x.begin(), disks.x.end());
  const auto [low_y, high_y] = std::minmax_element(disks.y.begin(), disks.y.end());
  return {{*low_x, *low_y}, {*high_x, *high_y}};
}

}  // namespace

Workspace::Workspace(const System& of, const SolverOptions& options)
    : system(of),
      options_(options),
      list_steps_(loops_for(usable_simd(options.simd), Neighbourhood::lists, true).list_steps),
      packing_fraction_(packing_fraction(of)) {}

void Workspace::begin_window(const State& start, Books& to, std::vector<Collision>* rows) {
  books = &to;
  log = rows;
  start_ = &start;
  length = start.clock.length;
  predicted = false;
  first_unpredicted = 0;
  least_distance_squared = predict::kNever;
  collisions = 0;
  turns_.clear();
  booked_.clear();
  generations_.clear();
  tie_time_ = -1;
  renewals_now_ = 0;
}

void Workspace::open(const State& start, Books& to, std::vector<Collision>* rows) {
  begin_window(start, to, rows);
  if (start.disks.size() == 0) return;
  const bool worn = renewals_ > 16 * records.size();  // neighbours in space are neighbours in memory no more
  const bool closed = std::exchange(closed_, false);  // at once: what follows may run out of memory
  if (!closed || worn || !continues(start) || rounding_slack(extent(0)) > slack_) {
    load(start, in_spatial_order(start.disks, extent_of(start.disks)));
    find_neighbours();
  }
  load_sums(to);
}

void Workspace::load_sums(const Books& from) {
  for (std::size_t k = 0; k < records.size(); ++k) virial[k] = from.virial_of[ids[k]];
  if (!system.box.has_walls()) return;
  wall_impulse.resize(records.size());
  for (std::size_t k = 0; k < records.size(); ++k) wall_impulse[k] = from.wall_impulse_of[ids[k]];
}

bool Workspace::continues(const State& start) const noexcept {
  if (start.disks.size() != records.size()) return false;
  for (std::size_t k = 0; k < records.size(); ++k) {
    const Record& own = records[k];
    const DiskId id = ids[k];
    if (own.x != start.disks.x[id] || own.y != start.disks.y[id] || own.vx != start.disks.vx[id] ||
        own.vy != start.disks.vy[id] || (!last_contact.empty() && last_contact[k] != start.last_contact[id])) {
      return false;
    }
  }
  return true;
}

/// These disks, in this order.
void Workspace::load(const State& start, std::span<const DiskId> order) {
  lists.reset();
  cells.reset();
  ids.assign(order.begin(), order.end());
  records.resize(order.size());
  virial.resize(order.size());
  one_kind = true;
  const Species& first = system.species_of_disk(order.empty() ? 0 : order[0]);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const DiskId id = order[k];
    const Species& kind = system.species_of_disk(id);
    records[k] = {start.disks.x[id],
                  start.disks.y[id],
                  start.disks.vx[id],
                  start.disks.vy[id],
                  0,
                  kind.radius,
                  predict::kNever,
                  kNobody,
                  0};
    one_kind = one_kind && kind == first;
  }
  last_contact.clear();
  if (!system.physics.elastic()) {
    last_contact.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      last_contact[k] = start.last_contact.empty() ? kNoContactYet : start.last_contact[order[k]];
    }
  }
  rate_ = 0;
  renewals_ = 0;
  renewals_allowed_ = 16 * order.size() + 256;
}

void Workspace::start_calendar() {
  const auto count = static_cast<double>(records.size());
  double width = options_.bucket_width;
  if (!(width > 0)) {
    double rate = rate_;
    if (!(rate > 0)) {
      double waiting = 0;
      for (const Record& own : records) waiting += std::min(own.next, length);
      rate = 1.3 * count * count / std::max(waiting, length * 1e-9);
    }
    width = kEventsPerBucket / rate;
  }
  width = std::max(width, length / (32 * count + 1024));
  // Far more buckets than events would fill only take room.
  calendar.start(length, width, static_cast<std::size_t>((count < 1e5 ? 0.5 : 0.25) * count) + 64);
}

Contact Workspace::earliest_contact(Index k) const {
  Contact best;
  const auto consider = [&](const Contact& candidate) {
    if (!(candidate.time < length)) return;
    if (candidate.time < best.time || (candidate.time == best.time && candidate.key < best.key)) best = candidate;
  };
  const Record& own = records[k];
  for_neighbours(k, [&](const Neighbour& neighbour) {
    const Record& other = records[neighbour.disk];
    const bool first = ids[k] < ids[neighbour.disk];
    const Record& i = first ? own : other;
    const Record& j = first ? other : own;
    const double time = predict::contact_of_disks(i.flight(), j.flight(), shift_of(neighbour.image, system.box.size),
                                                  i.radius + j.radius);
    const DiskId id_i = first ? ids[k] : ids[neighbour.disk];
    const DiskId id_j = first ? ids[neighbour.disk] : ids[k];
    consider({time, neighbour.disk, {true, id_i, id_j, neighbour.image}});
  });
  if (!may_meet_wall(k)) return best;
  for (const Wall wall : {Wall::left, Wall::right, Wall::bottom, Wall::top}) {
    if (!system.box.reflecting(axis_of(wall))) continue;
    const double time = contact_of_disk_and_wall(own.flight(), own.radius, wall, system.box.size);
    consider({time, partner_of(wall), {true, ids[k], id_of(wall), {}}});
  }
  return best;
}

Nearest Workspace::settled_contact(Index k) {
  const Contact contact = earliest_contact(k);
  if (cells) {
    cells->set_partner_image(k, contact.key.image);
  } else if (((*lists)[k].traits & List::kLong) != 0) {
    lists->set_partner_image(k, contact.key.image);
  }
  return {contact.time, contact.partner, false};
}

EventKey Workspace::key_of(Index k) const {
  const Index partner = records[k].partner;
  if (is_wall_partner(partner)) return {true, ids[k], id_of(wall_of_partner(partner)), {}};
  if (partner < 0) return {};
  return {true, std::min(ids[k], ids[partner]), std::max(ids[k], ids[partner]), partner_image(k)};
}

Image Workspace::fold(Index k) {
  Record& own = records[k];
  Image turns;
  if (system.box.periodic(0)) {
    const Wrapped wrapped = wrap(own.x, system.box.size.x);
    own.x = wrapped.coordinate;
    turns.x = static_cast<std::int32_t>(wrapped.turns);
  }
  if (system.box.periodic(1)) {
    const Wrapped wrapped = wrap(own.y, system.box.size.y);
    own.y = wrapped.coordinate;
    turns.y = static_cast<std::int32_t>(wrapped.turns);
  }
  if (turns != Image{}) {
    Turns& total = turns_[k];
    total.first += turns.x;
    total.second += turns.y;
  }
  return turns;
}

void Workspace::renew_list(Index k, double time) {
  if (patched) note_excursion(k, time);
  lists->renew(k, predict::position_at(records[k].flight(), time));
  ++renewals_;
  ++renewals_now_;
}

std::uint32_t Workspace::generation_before(Index k, double time) const noexcept {
  const Record& own = records[k];
  if (own.t != time || own.events == 0 || tie_time_ != time) return 0;
  const auto found = generations_.find(k);
  return found == generations_.end() ? 0 : found->second;
}

std::uint32_t Workspace::next_generation(Index i, Index j, double time) {
  const auto had_event = [&](Index k) { return records[k].t == time && records[k].events > 0; };
  if (!had_event(i) && !had_event(j)) return 0;
  const std::uint32_t generation = std::max(generation_before(i, time), generation_before(j, time)) + 1;
  if (tie_time_ != time) generations_.clear();
  tie_time_ = time;
  generations_[i] = generation;
  generations_[j] = generation;
  if (counts(i)) ++books->ties;
  return generation;
}

double Workspace::restitution_at(double time, double last, double restitution, bool counted) noexcept {
  if (!collapses(time, last, restitution, system.physics.t_c)) return restitution;
  if (counted) ++books->collapses;
  return 1;
}

Image Workspace::collide_with_wall(Index k, double time) {
  Record& own = records[k];
  const Wall wall = wall_of_partner(own.partner);
  const int axis = axis_of(wall);
  const std::uint32_t generation = next_generation(k, k, time);
  const Vec2 place = predict::position_at(own.flight(), time);
  own.x = place.x;
  own.y = place.y;
  own.t = time;
  const Image turns = fold(k);

  double restitution = system.physics.wall_restitution;
  if (!last_contact.empty()) {
    restitution = restitution_at(time, last_contact[k], restitution, counts(k));
    last_contact[k] = time;
  }
  double& v = axis == 0 ? own.vx : own.vy;
  const double v_before = v;
  v = rule::reflect(v_before, restitution);
  const double impulse = mass(k) * std::abs(v - v_before);
  ++own.events;

  wall_impulse[k] += impulse;
  if (patched) histories[k] = next_history(histories[k], time, id_of(wall), {}, {own.vx, own.vy});
  if (!counts(k)) return turns;
  ++books->wall_collisions;
  const Vec2 position{own.x, own.y};
  note_overlap(overlap_with_wall(position, own.radius, wall, system.box.size));
  if (log != nullptr) log->push_back(row_of_wall(time, generation, ids[k], wall, position, own.radius, impulse));
  return turns;
}

void Workspace::read(double time, Frame& frame) const {
  const std::size_t count = start_->disks.size();
  frame.resize(count);
  frame.winding_x = start_->disks.winding_x;
  frame.winding_y = start_->disks.winding_y;
  for (std::size_t k = 0; k < count; ++k) {
    const DiskId id = ids[k];
    Vec2 place = predict::position_at(records[k].flight(), time);
    if (system.box.periodic(0)) {
      const Wrapped wrapped = wrap(place.x, system.box.size.x);
      place.x = wrapped.coordinate;
      frame.winding_x[id] += wrapped.turns;
    }
    if (system.box.periodic(1)) {
      const Wrapped wrapped = wrap(place.y, system.box.size.y);
      place.y = wrapped.coordinate;
      frame.winding_y[id] += wrapped.turns;
    }
    frame.x[id] = place.x;
    frame.y[id] = place.y;
    frame.vx[id] = records[k].vx;
    frame.vy[id] = records[k].vy;
  }
  for (const auto& [k, turns] : turns_) {
    frame.winding_x[ids[k]] += turns.first;
    frame.winding_y[ids[k]] += turns.second;
  }
}

void Workspace::book() {
  books->collisions += collisions;
  collisions = 0;
  for (std::size_t k = 0; k < records.size(); ++k) {
    books->events_of[ids[k]] += records[k].events - (booked_.empty() ? 0 : booked_[k]);
    books->virial_of[ids[k]] = virial[k];
  }
  for (std::size_t k = 0; k < wall_impulse.size(); ++k) books->wall_impulse_of[ids[k]] = wall_impulse[k];
  booked_.resize(records.size());
  for (std::size_t k = 0; k < records.size(); ++k) booked_[k] = records[k].events;
  note_least_distance();
}

void Workspace::note_least_distance() noexcept {
  if (!one_kind || !(least_distance_squared < predict::kNever)) return;
  const double sigma = 2 * records[0].radius;
  note_overlap((sigma - std::sqrt(least_distance_squared)) / sigma);
}

void Workspace::carry_all(double time) {
  std::vector<std::pair<Index, Image>> folded;
  for (Index k = 0; k < static_cast<Index>(records.size()); ++k) {
    if (is_left_alone(k, time)) continue;
    Record& own = records[k];
    const Vec2 place = predict::position_at(own.flight(), time);
    own.x = place.x;
    own.y = place.y;
    own.t = time;
    const Image turns = fold(k);
    if (turns != Image{}) folded.emplace_back(k, turns);
  }
  for (const auto& [k, turns] : folded) {
    if (cells) {
      cells->fold(k, turns);
    } else {
      renew_list(k, time);
    }
  }
}

void Workspace::close(State& next) {
  if (records.empty()) {
    next.disks.resize(0);
    next.last_contact.clear();
    return;
  }
  carry_all(length);
  for (Record& own : records) {
    own.t = 0;
    own.events = 0;
  }
  for (double& time : last_contact) time -= length;

  next.disks.resize(records.size());
  next.disks.winding_x = start_->disks.winding_x;
  next.disks.winding_y = start_->disks.winding_y;
  next.last_contact.resize(last_contact.size());
  for (std::size_t k = 0; k < records.size(); ++k) {
    const DiskId id = ids[k];
    next.disks.x[id] = records[k].x;
    next.disks.y[id] = records[k].y;
    next.disks.vx[id] = records[k].vx;
    next.disks.vy[id] = records[k].vy;
    if (!last_contact.empty()) next.last_contact[id] = last_contact[k];
  }
  for (const auto& [k, turns] : turns_) {
    next.disks.winding_x[ids[k]] += turns.first;
    next.disks.winding_y[ids[k]] += turns.second;
  }
  rate_ = static_cast<double>(calendar.pushed()) / length;
  closed_ = true;
}

void Workspace::note_overlaps_of(Index k) {
  if (!counts(k)) return;
  const Record& own = records[k];
  const Vec2 size = system.box.size;
  for_neighbours(k, [&](const Neighbour& neighbour) {
    if (is_left_alone(neighbour.disk, length)) return;  // it was not moved to the end
    const Record& other = records[neighbour.disk];
    const bool first = ids[k] < ids[neighbour.disk];
    const Record& i = first ? own : other;
    const Record& j = first ? other : own;
    const Vec2 shift = shift_of(neighbour.image, size);
    const Vec2 r{(j.x + shift.x) - i.x, (j.y + shift.y) - i.y};
    const double sigma = i.radius + j.radius;
    if (dot(r, r) < sigma * sigma) note_overlap((sigma - carom::length(r)) / sigma);
  });
}

void Workspace::note_overlaps_with_walls() {
  for (const Wall wall : {Wall::left, Wall::right, Wall::bottom, Wall::top}) {
    if (!system.box.reflecting(axis_of(wall))) continue;
    for (Index k = 0; k < static_cast<Index>(records.size()); ++k) {
      const Record& own = records[k];
      if (counts(k)) note_overlap(overlap_with_wall({own.x, own.y}, own.radius, wall, system.box.size));
    }
  }
}

}  // namespace carom::fast
