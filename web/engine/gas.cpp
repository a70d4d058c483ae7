#include "gas.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "carom/io/scene_file.hpp"
#include "carom/run/exhaustion.hpp"

namespace carom::page {

Gas::Gas(Setup setup) { restart(std::move(setup), 0); }

// If the setup cannot be simulated all stays as it is.
void Gas::restart(Setup setup, double before) {
  setup.frame.time = 0;
  auto next = std::make_unique<Simulation>(std::move(setup));
  if (simulation_) recording_.leave(*simulation_);
  simulation_ = std::move(next);
  before_ = before;
  recording_.join(*simulation_, before_);
  frame_ = simulation_->frame();
  measured_from_ = 0;
  impulses_then_ = 0;
}

void Gas::go_on_with(Setup setup) {
  const std::uint64_t collisions = this->collisions();
  restart(std::move(setup), time());
  collisions_before_ = collisions;
}

void Gas::run_until(double time) {
  simulation_->run_until(std::max(time - before_, simulation_->time()));
  frame_ = simulation_->frame();
}

void Gas::run_collisions(std::uint64_t collisions) {
  while (this->collisions() < collisions && !collisions_are_over(system(), simulation_->window_start().disks)) {
    simulation_->run_window();
  }
  frame_ = simulation_->frame();
}

// Σ |J| σ where momentum is kept, Σ |J| at walls where they take it up.
double Gas::impulses() const {
  const Books& books = simulation_->books();
  const auto& sums = system().box.has_walls() ? books.wall_impulse_of : books.virial_of;
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

void Gas::measure_anew() {
  measured_from_ = simulation_->time();
  impulses_then_ = impulses();
}

std::optional<double> Gas::pressure() const {
  const double span = simulation_->time() - measured_from_;
  const double kT = temperature(system(), frame_);
  const Vec2 size = system().box.size;
  const Box& box = system().box;
  if (!(span > 0) || !(kT > 0) || box.boundary[0] != box.boundary[1]) return std::nullopt;
  const double flow = (impulses() - impulses_then_) / span;
  if (box.has_walls()) return flow / (2 * (size.x + size.y)) / kT;
  const double n = static_cast<double>(system().size());
  const double density = n / (size.x * size.y);
  return density * (1 + flow / (2 * n * kT));
}

Setup Gas::setup_now() const {
  Setup setup{system(), frame_};
  setup.frame.time = 0;
  return setup;
}

void Gas::equalize_speeds() {
  Setup setup = setup_now();
  const std::size_t kinds = system().species.size();
  std::vector<double> squares(kinds);
  std::vector<double> counts(kinds);
  for (std::size_t k = 0; k < frame_.size(); ++k) {
    squares[system().species_of[k]] += dot(frame_.velocity(k), frame_.velocity(k));
    counts[system().species_of[k]] += 1;
  }
  for (std::size_t k = 0; k < frame_.size(); ++k) {
    const std::uint32_t kind = system().species_of[k];
    const double speed = length(frame_.velocity(k));
    if (!(speed > 0)) continue;
    const double factor = std::sqrt(squares[kind] / counts[kind]) / speed;
    setup.frame.vx[k] *= factor;
    setup.frame.vy[k] *= factor;
  }
  restart(std::move(setup), before_);
}

void Gas::reverse() {
  Setup setup = setup_now();
  for (double& v : setup.frame.vx) v = -v;
  for (double& v : setup.frame.vy) v = -v;
  go_on_with(std::move(setup));
}

void Gas::resize(Vec2 size) {
  Setup setup = setup_now();
  setup.system.box.size = size;
  go_on_with(std::move(setup));
}

void Gas::add_disk(Species kind, Vec2 place) {
  Setup setup = setup_now();
  setup.system.add_disk(kind);
  setup.frame.add_disk(place, {});
  go_on_with(std::move(setup));
}

void Gas::remove_last_disk() {
  Setup setup = setup_now();
  setup.system.species_of.pop_back();
  setup.frame.resize(setup.system.size());
  go_on_with(std::move(setup));
}

// The window in flight is gone through once more: nobody took note of it.
void Gas::start_recording() {
  auto again = std::make_unique<Simulation>(simulation_->snapshot());
  recording_.start(time());
  recording_.join(*again, before_);
  again->run_until(simulation_->time());
  simulation_ = std::move(again);
}

std::string Gas::to_toml() const { return carom::to_toml({explicit_scene(setup_now(), "A gas from the page"), {}}); }

}  // namespace carom::page
