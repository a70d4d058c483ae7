#include "recording.hpp"

#include <algorithm>

namespace carom::page {

void Recording::start(double from) {
  kept_.clear();
  from_ = from;
  on_ = true;
}

// An observer costs time, also one that wants nothing.
void Recording::join(Simulation& simulation, double before) {
  before_ = before;
  if (on_) simulation.add_observer(*this);
}

void Recording::stop(const Simulation& simulation) {
  leave(simulation);
  on_ = false;
}

std::vector<Collision> Recording::in_flight(const Simulation& simulation) const {
  std::vector<Collision> rows;
  if (on_) append(rows, simulation.collisions_in_flight(), simulation.window_start().clock.start);
  return rows;
}

std::size_t Recording::count(const Simulation& simulation) const {
  return std::min(kMost, kept_.size() + in_flight(simulation).size());
}

std::vector<Collision> Recording::rows(const Simulation& simulation) const {
  std::vector<Collision> rows = kept_;
  for (const Collision& row : in_flight(simulation)) {
    if (rows.size() < kMost) rows.push_back(row);
  }
  return rows;
}

void Recording::on_window(const WindowRecord& window) {
  if (on_) append(kept_, window.collisions, window.before.clock.start);
}

// What lies before from() belongs to the window in which recording began.
void Recording::append(std::vector<Collision>& rows, std::span<const Collision> collisions, double window_start) const {
  for (Collision row : collisions) {
    row.time = before_ + (window_start + row.time);
    if (row.time >= from_ && rows.size() < kMost) rows.push_back(row);
  }
}

}  // namespace carom::page
