#include "carom/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "carom/base/error.hpp"
#include "carom/run/window_length.hpp"
#include "carom/state/validate.hpp"
#include "patched_solver.hpp"

namespace carom {
namespace {

const std::atomic<bool> kNeverInterrupted{false};

void throw_if_invalid(const Setup& setup) {
  std::vector<Problem> problems;
  for (const Finding& finding : validate(setup.system, setup.frame)) problems.push_back({finding.message, {}});
  if (!problems.empty()) throw Error(problems);
}

void throw_if_invalid(const Snapshot& snapshot) {
  std::vector<Problem> problems;
  for (const std::string& fault : faults_of(snapshot)) problems.push_back({fault, {}});
  if (!problems.empty()) throw Error(problems);
}

}  // namespace

Simulation::Simulation(Setup setup, const SolverOptions& solver, const ParallelOptions& parallel)
    : books_(setup.system.size(), setup.system.box.has_walls()), books_at_start_(0), interrupt_(&kNeverInterrupted) {
  throw_if_invalid(setup);
  state_ = initial_state(setup);
  system_ = std::move(setup.system);
  state_.clock.length = first_window_length(system_, state_);
  initial_ = {kinetic_energy(system_, state_.disks), momentum(system_, state_.disks),
              momentum_scale(system_, state_.disks)};
  choose_solver(solver, parallel);
}

Simulation::Simulation(Snapshot snapshot, const SolverOptions& solver, const ParallelOptions& parallel)
    : books_(0), books_at_start_(0), interrupt_(&kNeverInterrupted) {
  throw_if_invalid(snapshot);
  system_ = std::move(snapshot.system);
  state_ = std::move(snapshot.state);
  books_ = std::move(snapshot.books);
  measured_ = snapshot.measured;
  initial_ = snapshot.initial;
  measure_from_ = snapshot.measure_from;
  choose_solver(solver, parallel);
}

void Simulation::choose_solver(const SolverOptions& solver, const ParallelOptions& parallel) {
  const ParallelOptions chosen = divided(system_, state_, solver, parallel);
  if ((*chosen.patches)[0] * (*chosen.patches)[1] > 1) {
    auto divided = make_patched_solver(system_, solver, chosen);
    divided_ = divided.get();
    solver_ = std::move(divided);
  } else {
    solver_ = make_solver(system_, solver);
  }
}

Simulation::~Simulation() = default;

Division Simulation::division() const noexcept { return divided_ != nullptr ? divided_->division() : Division{}; }

void Simulation::add_observer(Observer& observer) { observers_.push_back(&observer); }

Simulation::Stop Simulation::run_until(double until) {
  if (!(until >= time())) throw Error(fmt::format("cannot run to time {}: the simulation is at {}", until, time()));
  if (until > kLatestTime) throw Error(fmt::format("cannot run to time {}: times end at {}", until, kLatestTime));
  while (until >= state_.clock.start + state_.clock.length) {
    if (run_window() == Stop::interrupted) return Stop::interrupted;
  }
  const double offset = until - state_.clock.start;
  return offset > offset_ ? advance_to(offset) : Stop::reached;
}

Simulation::Stop Simulation::run_window() {
  const double end = state_.clock.start + state_.clock.length;
  if (end > kLatestTime) throw Error(fmt::format("cannot run to time {}: times end at {}", end, kLatestTime));
  if (advance_to(state_.clock.length) == Stop::interrupted) return Stop::interrupted;
  close_window();
  return Stop::reached;
}

Frame Simulation::frame() const {
  Frame frame;
  if (open_) {
    solver_->read(offset_, frame);
  } else {
    frame = state_.disks;
  }
  frame.time = time();
  return frame;
}

Snapshot Simulation::snapshot() const {
  return {system_, state_, open_ ? books_at_start_ : books_, measured_, initial_, measure_from_};
}

std::vector<Collision> Simulation::collisions_in_flight() const {
  if (!open_) return {};
  std::vector<Collision> sorted = log_;
  std::sort(sorted.begin(), sorted.end(), stands_before);
  return sorted;
}

void Simulation::open_window(bool in_one_go) {
  if (!measured_.started && state_.clock.start >= measure_from_) {
    measured_ = {.started = true, .start = state_.clock.start, .kT_integral = 0};
    std::fill(books_.virial_of.begin(), books_.virial_of.end(), 0.0);
    std::fill(books_.wall_impulse_of.begin(), books_.wall_impulse_of.end(), 0.0);
  }
  watching_ = observers_.size();
  const bool arrays_stay = in_one_go && watching_ == 0 && solver_->sums_at_stops_only();
  books_at_start_ = arrays_stay ? books_.counts() : books_;
  log_.clear();
  const bool logs = std::any_of(observers_.begin(), observers_.end(),
                                [](const Observer* observer) { return observer->wants_collisions(); });
  solver_->open(state_, books_, logs ? &log_ : nullptr);
  open_ = true;
}

void Simulation::abandon_window() {
  if (books_at_start_.events_of.empty()) {
    books_.set_counts(books_at_start_);
  } else {
    books_ = books_at_start_;
  }
  offset_ = 0;
  open_ = false;
}

Simulation::Stop Simulation::advance_to(double offset) {
  if (!open_) open_window(offset == state_.clock.length);
  try {
    // The solver asks between events; here it is asked too where many short steps hold none.
    if (interrupt_->load(std::memory_order_relaxed) || !solver_->advance_to(offset, *interrupt_)) {
      abandon_window();
      return Stop::interrupted;
    }
  } catch (...) {
    abandon_window();  // a solver that ran out of memory stands between two events
    throw;
  }
  offset_ = offset;
  return Stop::reached;
}

void Simulation::close_window() {
  const Clock clock = state_.clock;
  const double kT_before = system_.physics.elastic() ? 0 : temperature(system_, state_.disks);
  // Nobody but observers looks back at the window's start: without them its place is taken by the end.
  State& end = watching_ > 0 ? next_ : state_;
  solver_->close(end);
  end.clock = {clock.window + 1, clock.start + clock.length, clock.length};
  end.disks.time = end.clock.start;
  end.clock.length = next_window_length(system_, end, books_.events() - books_at_start_.events());

  if (measured_.started && !system_.physics.elastic()) {
    measured_.kT_integral += 0.5 * (kT_before + temperature(system_, end.disks)) * clock.length;
  }
  std::sort(log_.begin(), log_.end(), stands_before);
  if (watching_ > 0) std::swap(state_, next_);
  offset_ = 0;
  open_ = false;
  const State& before = next_;
  const WindowRecord window{system_, before, state_, log_, books_at_start_, books_, measured_.started};
  for (std::size_t k = 0; k < watching_; ++k) observers_[k]->on_window(window);
}

}  // namespace carom
