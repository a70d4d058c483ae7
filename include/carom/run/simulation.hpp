// The simulation loop: windows strung together, probes at any time, observers told of every window.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "carom/run/parallel.hpp"
#include "carom/state/scene.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"
#include "carom/window/books.hpp"
#include "carom/window/collision.hpp"
#include "carom/window/solver.hpp"

namespace carom {

class DividedSolver;

/// One finished window, valid during the call that it is given to.
struct WindowRecord {
  const System& system;
  const State& before;                    ///< at its start
  const State& after;                     ///< at its end
  std::span<const Collision> collisions;  ///< in log order; times since before.clock.start; empty if no observer
                                          ///< of this window wants them
  const Books& books_before;              ///< what was counted and summed up to its start …
  const Books& books;                     ///< … and up to its end
  bool measured;                          ///< it starts at or after the time measuring begins: see measure_from()
};

/// No run goes beyond this time: flights would leave the range of doubles.
inline constexpr double kLatestTime = 1e75;

/// Sees the trajectory and changes nothing. What an observer throws reaches the caller of the simulation, which by then
/// stands at the window's end.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Whether windows are to come with their collisions, which costs time and memory.
  [[nodiscard]] virtual bool wants_collisions() const noexcept { return true; }
  /// After every finished window, in order. A window left in the middle is not reported until it is finished.
  virtual void on_window(const WindowRecord& window) = 0;
};

/// What impulses were summed over: the windows from one time on.
struct Measured {
  bool started = false;
  double start = 0;        ///< of the first window measured (time)
  double kT_integral = 0;  ///< ∫ kT dt from there to the start of the window in flight, by the trapezoidal rule
};

/// Energy, momentum and momentum scale at time 0: what drift is measured against.
struct Initial {
  double energy = 0;
  Vec2 momentum;
  double momentum_scale = 0;
};

/// All that decides how a simulation goes on and what it reports, at the start of a window.
struct Snapshot {
  System system;
  State state;
  Books books{0};
  Measured measured;
  Initial initial;
  double measure_from = 0;  ///< see Simulation::measure_from()
};

/// What makes a snapshot one that no simulation can have made: what validate() finds, arrays of other lengths, a clock
/// that does not tick in powers of two, numbers out of range. Empty if all is well.
std::vector<std::string> faults_of(const Snapshot& snapshot);

/// A system on its way through time. Neither copied nor moved; not for use by two threads at once.
class Simulation {
 public:
  /// Starts at time 0. Throws Error if the setup cannot be simulated.
  explicit Simulation(Setup setup, const SolverOptions& solver = {}, const ParallelOptions& parallel = {});
  /// Goes on from a snapshot with the same bits as the simulation that it was taken of, whatever the solver, its
  /// options, threads and patches of either. Throws Error with the snapshot's faults if it has any.
  explicit Simulation(Snapshot snapshot, const SolverOptions& solver = {}, const ParallelOptions& parallel = {});

  /// Why advancing ended.
  enum class Stop { reached, interrupted };

  /// Goes on to `until` (time). What comes later does not depend on how often or where a run was stopped.
  /// Interrupted, it returns to the start of the window it was in. Throws Error if `until` lies in the past
  /// or beyond kLatestTime.
  Stop run_until(double until);

  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Finishes the window that time() lies in, or the next one if time() is a window's start. Throws Error if that
  /// window ends beyond kLatestTime.
  Stop run_window();

  [[nodiscard]] const System& system() const noexcept { return system_; }
  [[nodiscard]] double time() const noexcept { return state_.clock.start + offset_; }
  /// The state at the start of the window that time() lies in: all that decides the future.
  [[nodiscard]] const State& window_start() const noexcept { return state_; }
  /// All disks at time(): a read of free flight.
  [[nodiscard]] Frame frame() const;
  /// The start of the window that time() lies in, and what was counted up to there.
  [[nodiscard]] Snapshot snapshot() const;
  /// Everything counted from time 0 to time(); sums of impulses from the start of measuring.
  [[nodiscard]] const Books& books() const noexcept { return books_; }
  /// Events of the window in flight up to time(), in log order; empty unless an observer wants collisions.
  [[nodiscard]] std::vector<Collision> collisions_in_flight() const;
  /// Windows begun so far; one that ends just now counts, one that starts just now does not.
  [[nodiscard]] std::uint64_t windows() const noexcept { return state_.clock.window + (offset_ > 0 ? 1 : 0); }

  /// Observers are called in the order added and must outlive the simulation. One added in the middle of a window
  /// starts with the next.
  void add_observer(Observer& observer);
  /// Virial and wall impulses are summed from the first window that starts at or after `time`; from 0 by default.
  /// Has no effect once measuring has begun.
  void measure_from(double time) noexcept { measure_from_ = time; }
  /// From when on impulses are summed.
  [[nodiscard]] const Measured& measured() const noexcept { return measured_; }
  /// The flag is polled between events; a signal handler may set it. It must outlive the simulation.
  void stop_when(const std::atomic<bool>& interrupt) noexcept { interrupt_ = &interrupt; }

  [[nodiscard]] const Solver& solver() const noexcept { return *solver_; }
  /// Into how many patches and threads windows were divided, and how that went.
  [[nodiscard]] Division division() const noexcept;
  [[nodiscard]] const Initial& initial() const noexcept { return initial_; }

 private:
  void choose_solver(const SolverOptions& solver, const ParallelOptions& parallel);
  void open_window(bool in_one_go);
  void abandon_window();
  Stop advance_to(double offset);
  void close_window();

  System system_;
  State state_;  // at the start of the window in flight
  State next_;   // buffer for its end
  double offset_ = 0;
  bool open_ = false;
  Books books_;
  Books books_at_start_;  // of the window in flight; without arrays where nobody can need them: they are large
  std::vector<Collision> log_;
  std::unique_ptr<Solver> solver_;
  DividedSolver* divided_ = nullptr;  // the same, if it divides its windows
  std::vector<Observer*> observers_;
  std::size_t watching_ = 0;  // observers of the window in flight: the first ones
  double measure_from_ = 0;
  Measured measured_;
  Initial initial_;
  const std::atomic<bool>* interrupt_;
};

}  // namespace carom
