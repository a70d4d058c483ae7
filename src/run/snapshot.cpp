// Is a snapshot one that a simulation can have made?
#include <cmath>
#include <initializer_list>

#include "carom/run/simulation.hpp"
#include "carom/state/validate.hpp"

namespace carom {
namespace {

constexpr double kMostEvents = 0x1p62;  // more than any run has, and far from where counts would wrap around

class Faults {
 public:
  void add_unless(bool sound, const char* fault) {
    if (!sound) found_.emplace_back(fault);
  }
  void add(std::string fault) { found_.push_back(std::move(fault)); }
  [[nodiscard]] bool none() const noexcept { return found_.empty(); }
  std::vector<std::string> take() { return std::move(found_); }

 private:
  std::vector<std::string> found_;
};

bool is_sum(double value) noexcept { return std::isfinite(value) && value >= 0; }

bool is_count(std::uint64_t value) noexcept { return static_cast<double>(value) < kMostEvents; }

template <typename Values, typename Predicate>
bool all(const Values& values, Predicate holds) {
  for (const auto value : values) {
    if (!holds(value)) return false;
  }
  return true;
}

void check_lengths(const Snapshot& snapshot, Faults& faults) {
  const std::size_t disks = snapshot.system.size();
  const Frame& frame = snapshot.state.disks;
  const Books& books = snapshot.books;
  bool equal = books.events_of.size() == disks && books.virial_of.size() == disks;
  for (const auto* column : {&frame.x, &frame.y, &frame.vx, &frame.vy}) equal = equal && column->size() == disks;
  for (const auto* column : {&frame.winding_x, &frame.winding_y}) equal = equal && column->size() == disks;
  faults.add_unless(equal, "its arrays have different lengths");
  const bool inelastic = !snapshot.system.physics.elastic();
  faults.add_unless(snapshot.state.last_contact.size() == (inelastic ? disks : 0),
                    "last contacts do not go with the restitution");
  faults.add_unless(books.wall_impulse_of.size() == (snapshot.system.box.has_walls() ? disks : 0),
                    "wall impulses do not go with the box");
}

void check_clock(const Clock& clock, double time, Faults& faults) {
  int exponent = 0;
  const bool length_sound =
      std::isfinite(clock.length) && clock.length > 0 && std::frexp(clock.length, &exponent) == 0.5;
  const bool start_sound = clock.start >= 0 && clock.start <= kLatestTime;
  faults.add_unless(length_sound, "the window's length is not a power of two");
  faults.add_unless(start_sound, "the window's start is out of range");
  faults.add_unless(is_count(clock.window), "the window's number is out of range");
  faults.add_unless(time == clock.start, "the disks' time is not the window's start");
  if (!length_sound || !start_sound) return;
  const double windows = clock.start / clock.length;
  faults.add_unless(windows == std::floor(windows) && windows < 0x1p53,
                    "the window's start is not a multiple of its length");
}

/// A window so long that its images could not be numbered.
void check_flights(const Snapshot& snapshot, Faults& faults) {
  constexpr double kMostCrossings = 0x1p24;
  const Box& box = snapshot.system.box;
  const Frame& frame = snapshot.state.disks;
  const auto crosses_few = [&](double size) {
    return [reach = kMostCrossings * size, length = snapshot.state.clock.length](double v) {
      return std::abs(v) * length <= reach;
    };
  };
  faults.add_unless((!box.periodic(0) || all(frame.vx, crosses_few(box.size.x))) &&
                        (!box.periodic(1) || all(frame.vy, crosses_few(box.size.y))),
                    "the window is too long for the speed of the disks");
}

void check_books(const Books& books, Faults& faults) {
  faults.add_unless(
      all(std::initializer_list<std::uint64_t>{books.collisions, books.wall_collisions, books.ties, books.collapses},
          is_count) &&
          all(books.events_of, is_count),
      "a count is out of range");
  faults.add_unless(is_sum(books.largest_overlap) && all(books.virial_of, is_sum) && all(books.wall_impulse_of, is_sum),
                    "a sum is negative or no number");
}

void check_measured(const Snapshot& snapshot, Faults& faults) {
  const Measured& measured = snapshot.measured;
  faults.add_unless(is_sum(measured.start) && is_sum(measured.kT_integral) && is_sum(snapshot.measure_from) &&
                        measured.start <= snapshot.state.clock.start,
                    "the time of measuring is out of range");
  const Initial& initial = snapshot.initial;
  faults.add_unless(is_sum(initial.energy) && is_sum(initial.momentum_scale) && std::isfinite(initial.momentum.x) &&
                        std::isfinite(initial.momentum.y),
                    "energy or momentum at the start is out of range");
}

}  // namespace

std::vector<std::string> faults_of(const Snapshot& snapshot) {
  Faults faults;
  check_lengths(snapshot, faults);
  check_clock(snapshot.state.clock, snapshot.state.disks.time, faults);
  check_flights(snapshot, faults);
  check_books(snapshot.books, faults);
  check_measured(snapshot, faults);
  faults.add_unless(all(snapshot.state.last_contact, [](double time) { return time <= 0; }),
                    "a last contact is in the future");
  constexpr std::int64_t kMostTurns = std::int64_t{1} << 62;
  const auto few = [](std::int64_t turns) { return turns > -kMostTurns && turns < kMostTurns; };
  faults.add_unless(all(snapshot.state.disks.winding_x, few) && all(snapshot.state.disks.winding_y, few),
                    "a winding number is out of range");
  if (!faults.none()) return faults.take();
  for (const Finding& finding : validate(snapshot.system, snapshot.state.disks)) faults.add(finding.message);
  return faults.take();
}

}  // namespace carom
