#include "playback.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "carom/base/error.hpp"
#include "carom/rule/collision.hpp"
#include "carom/run/exhaustion.hpp"
#include "carom/run/simulation.hpp"
#include "carom/run/window_length.hpp"

namespace carom::page {
namespace {

const std::atomic<bool> kNeverInterrupted{false};

double just_after(double offset) noexcept { return std::nextafter(offset, std::numeric_limits<double>::infinity()); }

/// Velocities of a wall's contact: the component along the wall's axis turns round.
Vec2 reflected(Vec2 v, Wall wall, double restitution) noexcept {
  if (axis_of(wall) == 0) return {rule::reflect(v.x, restitution), v.y};
  return {v.x, rule::reflect(v.y, restitution)};
}

}  // namespace

Playback::Playback(Setup setup) : books_(setup.system.size(), setup.system.box.has_walls()) {
  starts_.push_back(initial_state(setup));
  system_ = std::move(setup.system);
  starts_[0].clock.length = first_window_length(system_, starts_[0]);
  solver_ = make_reference_solver(system_);
}

void Playback::know_until(double time) {
  while (known_until() <= time && contacts_.size() < kMostContacts) advance_one_window();
}

void Playback::know_more_than(std::size_t count, double horizon) {
  while (contacts_.size() <= count && known_until() < horizon && contacts_.size() < kMostContacts && !is_over()) {
    advance_one_window();
  }
}

// Certain that neither disks nor walls will be met from the last window known on.
bool Playback::is_over() const noexcept {
  const Frame& disks = starts_.back().disks;
  return collisions_are_over(system_, disks) && (!system_.box.has_walls() || kinetic_energy(system_, disks) == 0);
}

void Playback::advance_one_window() {
  const State start = starts_.back();
  if (start.clock.start + start.clock.length > kLatestTime) throw Error("times end here");
  const std::uint64_t events = books_.events();
  std::vector<Collision> log;
  solver_->open(start, books_, &log);
  solver_->advance_to(start.clock.length, kNeverInterrupted);
  State next;
  solver_->close(next);
  next.clock = {start.clock.window + 1, start.clock.start + start.clock.length, start.clock.length};
  next.disks.time = next.clock.start;
  next.clock.length = next_window_length(system_, next, books_.events() - events);
  std::sort(log.begin(), log.end(), stands_before);
  take_apart(log);
  starts_.push_back(std::move(next));
}

// Contacts of one moment follow one another: each starts from the velocities that the one before it left.
void Playback::take_apart(const std::vector<Collision>& log) {
  const std::size_t window = starts_.size() - 1;
  Frame frame;
  double moment = -1;
  for (const Collision& row : log) {
    if (row.time != moment) {
      moment = row.time;
      frame = read(window, moment);
    }
    Contact contact;
    contact.time = starts_[window].clock.start + row.time;
    contact.window = window;
    contact.row = row;
    contact.position_i = frame.position(row.i);
    contact.before_i = frame.velocity(row.i);
    if (is_wall(row.j)) {
      contact.restitution = system_.physics.wall_restitution;
      contact.after_i = reflected(contact.before_i, wall_of(row.j), contact.restitution);
    } else {
      const Vec2 shift{row.image.x * system_.box.size.x, row.image.y * system_.box.size.y};
      contact.position_j = frame.position(row.j) + shift;
      contact.before_j = frame.velocity(row.j);
      const auto collide = [&](double restitution) {
        return rule::collide({.r = contact.position_j - contact.position_i,
                              .v = {contact.before_i, contact.before_j},
                              .m1 = system_.mass(row.i),
                              .m2 = system_.mass(row.j),
                              .restitution = restitution});
      };
      const auto misses = [&](const rule::Velocities& after) {
        const Vec2 before = contact.before_j;
        return std::abs(length(rule::impulse_on_second(system_.mass(row.j), {{}, before}, after)) - row.impulse);
      };
      contact.restitution = system_.physics.restitution;
      rule::Velocities after = collide(contact.restitution);
      if (const rule::Velocities elastic = collide(1); misses(elastic) < misses(after)) {
        contact.restitution = 1;  // the TC rule
        after = elastic;
      }
      contact.after_i = after.first;
      contact.after_j = after.second;
      frame.vx[row.j] = after.second.x;
      frame.vy[row.j] = after.second.y;
    }
    frame.vx[row.i] = contact.after_i.x;
    frame.vy[row.i] = contact.after_i.y;
    contacts_.push_back(contact);
  }
}

Frame Playback::read(std::size_t window, double offset) {
  Books unread(system_.size(), system_.box.has_walls());
  solver_->open(starts_[window], unread, nullptr);
  solver_->advance_to(offset, kNeverInterrupted);
  Frame frame;
  solver_->read(offset, frame);
  frame.time = starts_[window].clock.start + offset;
  return frame;
}

std::size_t Playback::window_of(double time) const noexcept {
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), time,
                                      [](double t, const State& state) { return t < state.clock.start; });
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - starts_.begin() - 1, 0));
}

Frame Playback::frame_at(double time) {
  know_until(time);
  const std::size_t window = std::min(window_of(time), starts_.size() - 2);
  const State& start = starts_[window];
  return read(window, std::clamp(time - start.clock.start, 0.0, start.clock.length));
}

Frame Playback::frame_after(std::size_t k) {
  const Contact& contact = contacts_.at(k);
  return read(contact.window, std::min(just_after(contact.row.time), starts_[contact.window].clock.length));
}

}  // namespace carom::page
