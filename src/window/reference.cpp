// The reference solver: the window map as plainly as it can be written. Every disk keeps its earliest event
// with anything; the next event of all is found by a linear scan. O(N) per event.

#include <algorithm>
#include <cmath>
#include <tuple>

#include "carom/base/error.hpp"
#include "carom/predict/contact.hpp"
#include "carom/rule/collision.hpp"
#include "carom/window/solver.hpp"
#include "encounter.hpp"

namespace carom {
namespace {

/// A disk inside a window: its flight since its own last event (or the window's start).
struct Body {
  predict::Flight flight;
  std::int64_t winding_x = 0;
  std::int64_t winding_y = 0;
  double last_contact = 0;
  int generation = -1;  // of the event at flight.time; −1 if that is the window's start
};

/// A contact that will happen if neither partner meets something else before.
struct Pending {
  double time = predict::kNever;
  DiskId i = 0;
  DiskId j = 0;
  Image image;

  [[nodiscard]] bool involves(DiskId disk) const noexcept { return i == disk || j == disk; }
};

/// Pending events are taken by (time, smaller id, larger id, image).
bool comes_before(const Pending& a, const Pending& b) noexcept {
  return std::tie(a.time, a.i, a.j, a.image) < std::tie(b.time, b.i, b.j, b.image);
}

/// Copies n of one axis: those n for which the relative coordinate can come within sigma.
struct ImageRange {
  std::int32_t first = 0;
  std::int32_t last = 0;
};

/// Throws Error if the copies are more than can be numbered.
ImageRange images_in_reach(double distance, double velocity, double duration, double sigma, double period) {
  const double end = distance + velocity * duration;
  constexpr double kSlack = 1e-6;  // more than rounding can move a copy, in periods
  const double first = std::ceil((-sigma - std::max(distance, end)) / period - kSlack);
  const double last = std::floor((sigma - std::min(distance, end)) / period + kSlack);
  constexpr double kFarthest = 0x1p30;
  if (!(first >= -kFarthest && last <= kFarthest)) {
    throw Error("a disk is so fast that it would cross the periodic box a thousand million times in one window");
  }
  return {static_cast<std::int32_t>(first), static_cast<std::int32_t>(last)};
}

class ReferenceSolver final : public Solver {
 public:
  explicit ReferenceSolver(const System& system) : system_(system) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "reference"; }
  [[nodiscard]] std::string_view simd() const noexcept override { return "scalar"; }

  void open(const State& start, Books& books, std::vector<Collision>* log) override {
    books_ = &books;
    log_ = log;
    length_ = start.clock.length;
    load(start);
    predicted_ = 0;
  }

  bool advance_to(double time, const std::atomic<bool>& interrupt) override {
    for (; predicted_ < size(); ++predicted_) {
      if (interrupt.load(std::memory_order_relaxed)) return false;
      next_of_[predicted_] = earliest_of(predicted_);
    }
    for (Pending next = earliest(); next.time < time; next = earliest()) {
      if (interrupt.load(std::memory_order_relaxed)) return false;
      if (is_wall(next.j)) {
        collide_with_wall(next);
      } else {
        collide_disks(next);
      }
      predict_again(next);
    }
    return true;
  }

  void read(double time, Frame& frame) const override {
    frame.resize(size());
    for (DiskId k = 0; k < size(); ++k) {
      Body body = bodies_[k];
      carry(body, time);
      frame.x[k] = body.flight.position.x;
      frame.y[k] = body.flight.position.y;
      frame.vx[k] = body.flight.velocity.x;
      frame.vy[k] = body.flight.velocity.y;
      frame.winding_x[k] = body.winding_x;
      frame.winding_y[k] = body.winding_y;
    }
  }

  void close(State& next) override {
    read(length_, next.disks);
    next.last_contact.resize(system_.physics.elastic() ? 0 : size());
    for (std::size_t k = 0; k < next.last_contact.size(); ++k) next.last_contact[k] = bodies_[k].last_contact - length_;
    note_overlaps(next.disks);
  }

 private:
  [[nodiscard]] DiskId size() const noexcept { return static_cast<DiskId>(system_.size()); }
  [[nodiscard]] double contact_distance(DiskId i, DiskId j) const noexcept {
    return system_.radius(i) + system_.radius(j);
  }
  [[nodiscard]] Vec2 shift(Image image) const noexcept { return shift_of(image, system_.box.size); }

  void load(const State& start) {
    bodies_.assign(size(), Body{});
    next_of_.assign(size(), Pending{});
    for (DiskId k = 0; k < size(); ++k) {
      Body& body = bodies_[k];
      body.flight = {start.disks.position(k), start.disks.velocity(k), 0};
      body.winding_x = start.disks.winding_x[k];
      body.winding_y = start.disks.winding_y[k];
      body.last_contact = start.last_contact.empty() ? kNoContactYet : start.last_contact[k];
    }
  }

  // --- prediction -----------------------------------------------------------------------------------------

  [[nodiscard]] Pending earliest() const noexcept {
    Pending best;
    for (const Pending& candidate : next_of_) {
      if (comes_before(candidate, best)) best = candidate;
    }
    return best;
  }

  /// The earliest event of disk k with anything before the window's end.
  [[nodiscard]] Pending earliest_of(DiskId k) const {
    Pending best;
    for (DiskId other = 0; other < size(); ++other) {
      if (other != k) consider_disks(std::min(k, other), std::max(k, other), best);
    }
    for (const Wall wall : {Wall::left, Wall::right, Wall::bottom, Wall::top}) consider_wall(k, wall, best);
    return best;
  }

  void consider(const Pending& candidate, Pending& best) const noexcept {
    if (candidate.time < length_ && comes_before(candidate, best)) best = candidate;
  }

  void consider_disks(DiskId i, DiskId j, Pending& best) const {
    const predict::Flight& a = bodies_[i].flight;
    const predict::Flight& b = bodies_[j].flight;
    const double sigma = contact_distance(i, j);
    const double start = std::max(a.time, b.time);
    const Vec2 r = predict::separation(a, b, {}, start);
    const Vec2 v = b.velocity - a.velocity;
    const Box& box = system_.box;
    const ImageRange x = box.periodic(0) ? images_in_reach(r.x, v.x, length_ - start, sigma, box.size.x) : ImageRange{};
    const ImageRange y = box.periodic(1) ? images_in_reach(r.y, v.y, length_ - start, sigma, box.size.y) : ImageRange{};
    for (std::int32_t nx = x.first; nx <= x.last; ++nx) {
      for (std::int32_t ny = y.first; ny <= y.last; ++ny) {
        const Image image{nx, ny};
        consider({predict::contact_of_disks(a, b, shift(image), sigma), i, j, image}, best);
      }
    }
  }

  void consider_wall(DiskId k, Wall wall, Pending& best) const noexcept {
    if (!system_.box.reflecting(axis_of(wall))) return;
    const double time = contact_of_disk_and_wall(bodies_[k].flight, system_.radius(k), wall, system_.box.size);
    consider({time, k, id_of(wall), {}}, best);
  }

  /// After an event: new predictions for its disks, and for every disk whose earliest event was with one of them.
  void predict_again(const Pending& done) {
    for (DiskId k = 0; k < size(); ++k) {
      const Pending& next = next_of_[k];
      if (k != done.i && k != done.j && next.time == predict::kNever) continue;
      const bool stale =
          k == done.i || k == done.j || next.involves(done.i) || (!is_wall(done.j) && next.involves(done.j));
      if (stale) next_of_[k] = earliest_of(k);
    }
  }

  // --- events ---------------------------------------------------------------------------------------------

  /// Free flight to `time`, and the position folded into the box. Returns how many periods were taken off.
  Image carry(Body& body, double time) const noexcept {
    predict::Flight& flight = body.flight;
    flight.position = predict::position_at(flight, time);
    flight.time = time;
    Image turns;
    if (system_.box.periodic(0)) turns.x = fold(flight.position.x, body.winding_x, system_.box.size.x);
    if (system_.box.periodic(1)) turns.y = fold(flight.position.y, body.winding_y, system_.box.size.y);
    return turns;
  }

  static std::int32_t fold(double& coordinate, std::int64_t& winding, double period) noexcept {
    const Wrapped wrapped = wrap(coordinate, period);
    coordinate = wrapped.coordinate;
    winding += wrapped.turns;
    return static_cast<std::int32_t>(wrapped.turns);
  }

  static int generation_at(const Body& body, double time) noexcept {
    return body.flight.time == time ? body.generation : -1;
  }

  /// The TC rule: a contact too soon after either disk's last one is elastic.
  double restitution_at(double time, double last_contact, double restitution) noexcept {
    if (!collapses(time, last_contact, restitution, system_.physics.t_c)) return restitution;
    ++books_->collapses;
    return 1;
  }

  void book_event(Body& body, DiskId k, double time, int generation) noexcept {
    body.generation = generation;
    body.last_contact = time;
    ++books_->events_of[k];
  }

  void collide_disks(const Pending& event) {
    Body& a = bodies_[event.i];
    Body& b = bodies_[event.j];
    const double time = event.time;
    const int generation = std::max(generation_at(a, time), generation_at(b, time)) + 1;
    const Image turns_a = carry(a, time);
    const Image turns_b = carry(b, time);
    const Image image{event.image.x + turns_b.x - turns_a.x, event.image.y + turns_b.y - turns_a.y};
    const double last_contact = std::max(a.last_contact, b.last_contact);
    const DiskEncounter encounter =
        encounter_of_disks(separation_at_contact(a.flight.position, b.flight.position, shift(image)),
                           {a.flight.velocity, b.flight.velocity}, system_.mass(event.i), system_.mass(event.j),
                           restitution_at(time, last_contact, system_.physics.restitution));
    a.flight.velocity = encounter.after.first;
    b.flight.velocity = encounter.after.second;

    const double sigma = contact_distance(event.i, event.j);
    const double virial = encounter.impulse * sigma;
    books_->virial_of[event.i] += 0.5 * virial;
    books_->virial_of[event.j] += 0.5 * virial;
    ++books_->collisions;
    books_->ties += generation > 0;
    book_event(a, event.i, time, generation);
    book_event(b, event.j, time, generation);
    note_overlap((sigma - length(encounter.r)) / sigma);
    if (log_ == nullptr) return;
    log_->push_back(row_of_disks(time, static_cast<std::uint32_t>(generation), event.i, event.j, event.image,
                                 a.flight.position, system_.radius(event.i), encounter));
  }

  void collide_with_wall(const Pending& event) {
    Body& body = bodies_[event.i];
    const double time = event.time;
    const Wall wall = wall_of(event.j);
    const int axis = axis_of(wall);
    const int generation = generation_at(body, time) + 1;
    carry(body, time);

    const double restitution = restitution_at(time, body.last_contact, system_.physics.wall_restitution);
    double& v = axis == 0 ? body.flight.velocity.x : body.flight.velocity.y;
    const double v_before = v;
    v = rule::reflect(v_before, restitution);
    const double impulse = system_.mass(event.i) * std::abs(v - v_before);

    books_->wall_impulse_of[event.i] += impulse;
    ++books_->wall_collisions;
    books_->ties += generation > 0;
    book_event(body, event.i, time, generation);
    const double radius = system_.radius(event.i);
    note_overlap(overlap_with_wall(body.flight.position, radius, wall, system_.box.size));
    if (log_ == nullptr) return;
    log_->push_back(row_of_wall(time, static_cast<std::uint32_t>(generation), event.i, wall, body.flight.position,
                                radius, impulse));
  }

  // --- certificate ----------------------------------------------------------------------------------------

  void note_overlap(double overlap) noexcept { books_->largest_overlap = std::max(books_->largest_overlap, overlap); }

  /// No pair may overlap at a window's end and no disk reach past a wall: a missed collision would show here.
  void note_overlaps(const Frame& frame) {
    const Box& box = system_.box;
    for (DiskId i = 0; i < size(); ++i) {
      for (const Wall wall : {Wall::left, Wall::right, Wall::bottom, Wall::top}) {
        if (!box.reflecting(axis_of(wall))) continue;
        note_overlap(overlap_with_wall(frame.position(i), system_.radius(i), wall, box.size));
      }
      for (DiskId j = i + 1; j < size(); ++j)
        note_overlap_of_pair(frame.position(i), frame.position(j), contact_distance(i, j));
    }
  }

  void note_overlap_of_pair(Vec2 i, Vec2 j, double sigma) {
    const Box& box = system_.box;
    const Vec2 r = j - i;
    const ImageRange x = box.periodic(0) ? images_in_reach(r.x, 0, 0, sigma, box.size.x) : ImageRange{};
    const ImageRange y = box.periodic(1) ? images_in_reach(r.y, 0, 0, sigma, box.size.y) : ImageRange{};
    for (std::int32_t nx = x.first; nx <= x.last; ++nx) {
      for (std::int32_t ny = y.first; ny <= y.last; ++ny) {
        note_overlap((sigma - length((j + shift({nx, ny})) - i)) / sigma);
      }
    }
  }

  const System& system_;
  double length_ = 0;
  std::vector<Body> bodies_;
  std::vector<Pending> next_of_;
  DiskId predicted_ = 0;  // disks below this one have had their first prediction
  Books* books_ = nullptr;
  std::vector<Collision>* log_ = nullptr;
};

}  // namespace

std::unique_ptr<Solver> make_reference_solver(const System& system) {
  return std::make_unique<ReferenceSolver>(system);
}

}  // namespace carom
