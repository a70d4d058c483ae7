#include "recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace carom::test {
namespace {

class KeepEvents final : public Observer {
 public:
  void on_window(const WindowRecord& window) override {
    events.assign(window.collisions.begin(), window.collisions.end());
  }
  std::vector<Collision> events;
};

bool same_bits(double a, double b) noexcept {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::optional<std::string> difference(const char* what, double expected, double actual) {
  if (same_bits(expected, actual)) return std::nullopt;
  return fmt::format("{} is {} ({:a}), expected {} ({:a})", what, actual, actual, expected, expected);
}

template <typename Whole>
std::optional<std::string> difference(const char* what, Whole expected, Whole actual) {
  if (expected == actual) return std::nullopt;
  return fmt::format("{} is {}, expected {}", what, actual, expected);
}

template <typename Value>
std::optional<std::string> difference(const char* what, const std::vector<Value>& expected,
                                      const std::vector<Value>& actual) {
  if (const auto found = difference("size", expected.size(), actual.size())) return fmt::format("{}: {}", what, *found);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (const auto found = difference(what, expected[k], actual[k])) return fmt::format("disk {}: {}", k, *found);
  }
  return std::nullopt;
}

/// Compares things one after another; keeps what the first difference says.
class Comparison {
 public:
  template <typename Value>
  Comparison& of(const char* what, const Value& expected, const Value& actual) {
    if (!found_) found_ = difference(what, expected, actual);
    return *this;
  }
  [[nodiscard]] std::optional<std::string> found() const { return found_; }

 private:
  std::optional<std::string> found_;
};

std::string text_of(const Collision& c) {
  return fmt::format("t={} ({:a}) generation {} i={} j={} image ({}, {}) point ({}, {}) normal ({}, {}) impulse {}",
                     c.time, c.time, c.generation, c.i, c.j, c.image.x, c.image.y, c.point.x, c.point.y, c.normal.x,
                     c.normal.y, c.impulse);
}

bool same_event(const Collision& a, const Collision& b) noexcept {
  return same_bits(a.time, b.time) && a.generation == b.generation && a.i == b.i && a.j == b.j && a.image == b.image &&
         same_bits(a.point.x, b.point.x) && same_bits(a.point.y, b.point.y) && same_bits(a.normal.x, b.normal.x) &&
         same_bits(a.normal.y, b.normal.y) && same_bits(a.impulse, b.impulse);
}

std::optional<std::string> difference_of_events(const std::vector<Collision>& expected,
                                                const std::vector<Collision>& actual) {
  const auto text = [](const std::vector<Collision>& events, std::size_t k) {
    return k < events.size() ? text_of(events[k]) : std::string("none");
  };
  for (std::size_t k = 0; k < std::max(expected.size(), actual.size()); ++k) {
    if (k < expected.size() && k < actual.size() && same_event(expected[k], actual[k])) continue;
    return fmt::format("event {} of {}:\n  expected {}\n  actual   {}", k, expected.size(), text(expected, k),
                       text(actual, k));
  }
  return std::nullopt;
}

std::optional<std::string> difference_of_frames(const Frame& expected, const Frame& actual) {
  return Comparison()
      .of("time", expected.time, actual.time)
      .of("x", expected.x, actual.x)
      .of("y", expected.y, actual.y)
      .of("vx", expected.vx, actual.vx)
      .of("vy", expected.vy, actual.vy)
      .of("winding_x", expected.winding_x, actual.winding_x)
      .of("winding_y", expected.winding_y, actual.winding_y)
      .of("digest", digest(expected), digest(actual))
      .found();
}

std::optional<std::string> difference_of_books(const Books& expected, const Books& actual) {
  return Comparison()
      .of("collisions", expected.collisions, actual.collisions)
      .of("wall_collisions", expected.wall_collisions, actual.wall_collisions)
      .of("ties", expected.ties, actual.ties)
      .of("collapses", expected.collapses, actual.collapses)
      .of("events_of", expected.events_of, actual.events_of)
      .of("virial_of", expected.virial_of, actual.virial_of)
      .of("wall_impulse_of", expected.wall_impulse_of, actual.wall_impulse_of)
      .of("largest_overlap", expected.largest_overlap, actual.largest_overlap)
      .found();
}

std::optional<std::string> difference_of_glimpses(const Glimpse& expected, const Glimpse& actual) {
  if (auto found = difference_of_events(expected.events, actual.events)) return found;
  if (auto found = difference_of_frames(expected.frame, actual.frame)) return found;
  return difference_of_books(expected.books, actual.books);
}

std::optional<std::string> difference_of_windows(const WindowTrace& expected, const WindowTrace& actual) {
  for (std::size_t k = 0; k < expected.probes.size(); ++k) {
    const auto found = difference_of_glimpses(expected.probes[k], actual.probes[k]);
    if (found) return fmt::format("at probe {}: {}", k, *found);
  }
  if (const auto found = difference_of_glimpses(expected.end, actual.end)) return "at the end: " + *found;
  const auto found = Comparison()
                         .of("number of the next window", expected.after.clock.window, actual.after.clock.window)
                         .of("start of the next window", expected.after.clock.start, actual.after.clock.start)
                         .of("length of the next window", expected.after.clock.length, actual.after.clock.length)
                         .of("last_contact", expected.after.last_contact, actual.after.last_contact)
                         .found();
  if (found) return found;
  const auto of_disks = difference_of_frames(expected.after.disks, actual.after.disks);
  return of_disks ? std::optional("in the state after it: " + *of_disks) : std::nullopt;
}

WindowTrace record_window(Simulation& simulation, const KeepEvents& keeper, int probes) {
  constexpr std::array kShares{0.5, 0.37};  // one half: where lattices have their events
  WindowTrace trace;
  const Clock clock = simulation.window_start().clock;
  for (int probe = probes; probe-- > 0;) {
    simulation.run_until(clock.start + kShares[probe] * clock.length);
    trace.probes.push_back({simulation.frame(), simulation.books(), simulation.collisions_in_flight()});
  }
  simulation.run_window();
  trace.end = {simulation.frame(), simulation.books(), keeper.events};
  trace.after = simulation.window_start();
  return trace;
}

}  // namespace

Recording record(const Setup& setup, const SolverOptions& options, const Extent& extent) {
  Simulation simulation(setup, options);
  return record(simulation, extent);
}

Recording record(Simulation& simulation, const Extent& extent) {
  constexpr std::size_t kLeastWindows = 3;
  KeepEvents keeper;
  simulation.add_observer(keeper);
  Recording recording;
  while (recording.windows.size() < extent.windows &&
         (recording.windows.size() < kLeastWindows || simulation.books().events() < extent.events)) {
    recording.windows.push_back(record_window(simulation, keeper, extent.probes));
  }
  return recording;
}

std::optional<std::string> first_difference(const Recording& expected, const Recording& actual) {
  for (std::size_t k = 0; k < std::min(expected.windows.size(), actual.windows.size()); ++k) {
    const auto found = difference_of_windows(expected.windows[k], actual.windows[k]);
    if (found) return fmt::format("window {}, {}", k, *found);
  }
  return difference("number of windows", expected.windows.size(), actual.windows.size());
}

}  // namespace carom::test
