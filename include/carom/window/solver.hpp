// The window map State(t0) → State(t0 + Δ), opened, advanced and closed by a solver.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "carom/base/simd.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"
#include "carom/window/books.hpp"
#include "carom/window/collision.hpp"

namespace carom {

/// Works on one window at a time. Every solver gives the same bits and the same events for the same State.
///
/// A window holds the events with times in [0, Δ) from its start; times below are measured from there.
/// Use: open(), advance_to() with growing times and read() as often as wanted, then close() or abandon it by
/// opening another. What open() is given must outlive the window.
class Solver {
 public:
  virtual ~Solver() = default;
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// What its prediction loop is compiled for: "scalar", "AVX2", …
  [[nodiscard]] virtual std::string_view simd() const noexcept = 0;

  /// Whether the books' arrays change only when advance_to() has returned true.
  [[nodiscard]] virtual bool sums_at_stops_only() const noexcept { return false; }

  /// Begins the window that starts with `start`. Counts and sums are added to `books`; events are appended to
  /// `log` in the order of processing unless it is null.
  virtual void open(const State& start, Books& books, std::vector<Collision>* log) = 0;

  /// Processes all events before `time` ≤ Δ. Returns false if it stopped early because `interrupt` became true;
  /// the window must then be abandoned.
  virtual bool advance_to(double time, const std::atomic<bool>& interrupt) = 0;

  /// The disks at `time`, not before the time advanced to and not after the next event: a read of free flight
  /// that changes nothing. Sets all of `frame` but its time.
  virtual void read(double time, Frame& frame) const = 0;

  /// The state at the window's end, after advance_to(Δ). Sets disks and last contacts, not the clock. `next` may be the
  /// state that open() was given.
  virtual void close(State& next) = 0;
};

enum class SolverKind {
  fast,      ///< neighbour lists or a grid of cells, an event calendar, vector instructions
  reference  ///< written for clarity: all pairs, all images in reach, a linear scan for the next event
};

/// How the fast solver finds the disks near a disk.
enum class Neighbourhood {
  lists,  ///< a list per disk, renewed when the disk has gone half its shell: best in dense systems
  cells   ///< a grid whose cells report every crossing: best in dilute systems
};

/// Which solver, and how it goes about it. Changes the speed and never a bit of the results.
struct SolverOptions {
  SolverKind kind = SolverKind::fast;
  // What follows is for the fast solver.
  std::optional<Simd> simd = {};                    ///< one of available_simd(); the fastest by default
  std::optional<Neighbourhood> neighbourhood = {};  ///< chosen from the density by default
  double shell = 0;         ///< how much farther than contact a list reaches (length); 0: from the density
  double cell_size = 0;     ///< least width of a cell (length); 0: from the density
  double bucket_width = 0;  ///< of the event calendar (time); 0: from the rate of events
};

/// Throws Error if the processor lacks the instructions asked for. `system` must outlive the solver.
std::unique_ptr<Solver> make_solver(const System& system, const SolverOptions& options = {});

/// The two kinds by themselves.
std::unique_ptr<Solver> make_reference_solver(const System& system);
std::unique_ptr<Solver> make_fast_solver(const System& system, const SolverOptions& options = {});

}  // namespace carom
