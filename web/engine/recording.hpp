// The collisions of a gas, kept from one time on, up to a number that memory has room for.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "carom/run/simulation.hpp"

namespace carom::page {

/// Watches one simulation after the other, as the gas goes on with them; times are those of the gas.
class Recording final : public Observer {
 public:
  /// No more are kept.
  static constexpr std::size_t kMost = 200000;

  /// Begins anew, to keep what happens from time `from` on. A simulation is to be joined next.
  void start(double from);
  /// The gas goes on with this simulation, which begins at time `before` of the gas and stands at a window's start.
  void join(Simulation& simulation, double before);
  /// Keeps what there is of the window in flight, before another simulation is joined.
  void leave(const Simulation& simulation) { kept_ = rows(simulation); }
  /// No more is kept.
  void stop(const Simulation& simulation);

  /// The time from which on all contacts are kept.
  [[nodiscard]] double from() const noexcept { return from_; }
  /// How many rows() has.
  [[nodiscard]] std::size_t count(const Simulation& simulation) const;
  /// All that is kept, with what has happened of the window in flight.
  [[nodiscard]] std::vector<Collision> rows(const Simulation& simulation) const;

  [[nodiscard]] bool wants_collisions() const noexcept override { return on_ && kept_.size() < kMost; }
  void on_window(const WindowRecord& window) override;

 private:
  [[nodiscard]] std::vector<Collision> in_flight(const Simulation& simulation) const;
  void append(std::vector<Collision>& rows, std::span<const Collision> collisions, double window_start) const;

  std::vector<Collision> kept_;
  bool on_ = false;
  double from_ = 0;
  double before_ = 0;  // time that earlier simulations took
};

}  // namespace carom::page
