#include "workspace.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

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

void Workspace::open(const State& start, Books& to, std::vector<Collision>* rows) {
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
  if (start.disks.size() == 0) return;
  renewals_now_ = 0;
  const bool worn = renewals_ > 16 * records.size();  // neighbours in space are neighbours in memory no more
  if (!closed_ || worn || !continues(start) || rounding_slack(extent(0)) > slack_) load(start);
  closed_ = false;
  for (std::size_t k = 0; k < records.size(); ++k) virial[k] = to.virial_of[ids[k]];
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

void Workspace::load(const State& start) {
  const std::vector<DiskId> order = in_spatial_order(start.disks, extent_of(start.disks));
  lists.reset();
  cells.reset();
  ids.assign(order.begin(), order.end());
  records.resize(order.size());
  virial.resize(order.size());
  one_kind = true;
  const Species& first = system.species_of_disk(0);
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
  find_neighbours();
}

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
  const Box& box = system.box;
  const double width = box.boundary[0] == Boundary::open ? extent.high.x - extent.low.x + diameter : box.size.x;
  const double height = box.boundary[1] == Boundary::open ? extent.high.y - extent.low.y + diameter : box.size.y;
  const double reach = std::sqrt(kDisks * width * height / (count * kPi));
  return std::clamp(reach - diameter, 0.1 * diameter, 8 * diameter);
}

void Workspace::find_neighbours() {
  const Extent range = extent(0);
  slack_ = 4 * rounding_slack(range);  // with some room for the windows to come
  if (chooses_cells()) {
    const double width = options_.cell_size > 0 ? options_.cell_size : default_cell_size();
    cells = std::make_unique<Cells>(system, width, 2 * slack_, records, ids);
  } else {
    build_lists(range);
  }
}

/// Lists where the disks are dense or of very different sizes, and where the box is not made for cells.
bool Workspace::chooses_cells() const {
  constexpr double kDensest = 0.65;         // packing fraction from which on lists were measured to be faster
  constexpr double kWidestSizeRatio = 2.5;  // a cell is as wide as the largest disk
  if (!Cells::fit(system, 2 * slack_)) return false;
  if (options_.neighbourhood) return *options_.neighbourhood == Neighbourhood::cells;
  double smallest = predict::kNever;
  double largest = 0;
  for (const Record& own : records) {
    smallest = std::min(smallest, own.radius);
    largest = std::max(largest, own.radius);
  }
  return largest <= kWidestSizeRatio * smallest && packing_fraction(system) < kDensest;
}

/// So wide that a cell holds about kDisks disks.
double Workspace::default_cell_size() const noexcept {
  constexpr double kDisks = 0.8;
  const Box& box = system.box;
  return std::sqrt(kDisks * box.size.x / static_cast<double>(records.size()) * box.size.y);
}

void Workspace::build_lists(const Extent& range) {
  constexpr double kTooMany = 20;
  const double least = 4 * slack_;
  double shell = std::max(options_.shell > 0 ? options_.shell : default_shell(range), least);
  lists = std::make_unique<Lists>(system, range, shell, slack_, records, ids, 0);
  // Where the disks crowd in a part of the plane, the mean density said too little.
  while (options_.shell == 0 && shell / 2 >= least && shell > 0.2 * records[0].radius &&
         lists->mean_length() > kTooMany) {
    shell /= 2;
    lists = std::make_unique<Lists>(system, range, shell, slack_, records, ids, 0);
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
  lists = std::make_unique<Lists>(system, extent(time), shell, slack_, records, ids, time);
  predicted = false;
  first_unpredicted = 0;
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
  calendar.start(length, width, static_cast<std::size_t>(0.5 * count) + 64);
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
  ++books->ties;
  return generation;
}

double Workspace::restitution_at(double time, double last, double restitution) noexcept {
  if (!collapses(time, last, restitution, system.physics.t_c)) return restitution;
  ++books->collapses;
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
    restitution = restitution_at(time, last_contact[k], restitution);
    last_contact[k] = time;
  }
  double& v = axis == 0 ? own.vx : own.vy;
  const double v_before = v;
  v = rule::reflect(v_before, restitution);
  const double impulse = mass(k) * std::abs(v - v_before);
  ++own.events;

  books->wall_impulse_of[ids[k]] += impulse;
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
  booked_.resize(records.size());
  for (std::size_t k = 0; k < records.size(); ++k) booked_[k] = records[k].events;
  if (one_kind && least_distance_squared < predict::kNever) {
    const double sigma = 2 * records[0].radius;
    note_overlap((sigma - std::sqrt(least_distance_squared)) / sigma);
  }
}

void Workspace::close(State& next) {
  if (records.empty()) {
    next.disks.resize(0);
    next.last_contact.clear();
    return;
  }
  std::vector<std::pair<Index, Image>> folded;
  for (Index k = 0; k < static_cast<Index>(records.size()); ++k) {
    Record& own = records[k];
    const Vec2 place = predict::position_at(own.flight(), length);
    own.x = place.x;
    own.y = place.y;
    own.t = 0;
    own.events = 0;
    const Image turns = fold(k);
    if (turns != Image{}) folded.emplace_back(k, turns);
  }
  for (const auto& [k, turns] : folded) {
    if (cells) {
      cells->fold(k, turns);
    } else {
      renew_list(k, 0);
    }
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
  const Record& own = records[k];
  const Vec2 size = system.box.size;
  for_neighbours(k, [&](const Neighbour& neighbour) {
    const Record& other = records[neighbour.disk];
    const bool first = ids[k] < ids[neighbour.disk];
    const Record& i = first ? own : other;
    const Record& j = first ? other : own;
    const Vec2 shift = shift_of(neighbour.image, size);
    const Vec2 r{(j.x + shift.x) - i.x, (j.y + shift.y) - i.y};
    const double sigma = i.radius + j.radius;
    if (dot(r, r) < sigma * sigma) note_overlap((sigma - carom::length(r)) / sigma);
  });
  if (!may_meet_wall(k)) return;
  for (const Wall wall : {Wall::left, Wall::right, Wall::bottom, Wall::top}) {
    if (!system.box.reflecting(axis_of(wall))) continue;
    note_overlap(overlap_with_wall({own.x, own.y}, own.radius, wall, size));
  }
}

}  // namespace carom::fast
