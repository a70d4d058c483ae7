// Many disks: a simulation that can be turned round and given more room.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "carom/run/simulation.hpp"
#include "carom/run/summary.hpp"
#include "carom/state/scene.hpp"
#include "recording.hpp"

namespace carom::page {

class Gas {
 public:
  /// Throws Error if the setup cannot be simulated.
  explicit Gas(Setup setup);

  [[nodiscard]] const System& system() const noexcept { return simulation_->system(); }
  /// Since the gas was made (time).
  [[nodiscard]] double time() const noexcept { return before_ + simulation_->time(); }
  void run_until(double time);
  /// Whole windows, until there were so many collisions since the gas was made.
  void run_collisions(std::uint64_t collisions);
  [[nodiscard]] const Frame& frame() const noexcept { return frame_; }
  /// Of what happened since the last reverse() or resize().
  [[nodiscard]] Summary summary() const { return summarize(*simulation_); }
  /// Contacts since the gas was made.
  [[nodiscard]] std::uint64_t collisions() const noexcept {
    return collisions_before_ + simulation_->books().collisions;
  }
  /// Starts to measure the pressure anew with the next window.
  void measure_anew();
  /// Mean βP since then; absent before a window was measured.
  [[nodiscard]] std::optional<double> pressure() const;

  /// All disks of one kind given the same speed, in the directions they have; the energy stays, kind by kind.
  void equalize_speeds();
  /// All velocities turned round: the gas goes back the way it came.
  void reverse();
  /// The walls moved to these sizes, which must hold all disks; velocities stay.
  void resize(Vec2 size);
  /// One disk more, at rest, as the last one.
  void add_disk(Species kind, Vec2 place);
  void remove_last_disk();
  /// The scene as it is now, in TOML.
  [[nodiscard]] std::string to_toml() const;

  /// From now on all contacts are kept; what was kept before is not.
  void start_recording();
  void stop_recording() { recording_.stop(*simulation_); }
  [[nodiscard]] double recorded_from() const noexcept { return recording_.from(); }
  [[nodiscard]] std::size_t recorded() const { return recording_.count(*simulation_); }
  /// Times are since the gas was made.
  [[nodiscard]] std::vector<Collision> recorded_collisions() const { return recording_.rows(*simulation_); }

 private:
  void restart(Setup setup, double before);
  void go_on_with(Setup setup);
  [[nodiscard]] Setup setup_now() const;
  [[nodiscard]] double impulses() const;

  std::unique_ptr<Simulation> simulation_;
  Recording recording_;
  Frame frame_;
  double before_ = 0;  // time that earlier simulations took
  std::uint64_t collisions_before_ = 0;
  double measured_from_ = 0;  // of this simulation (time)
  double impulses_then_ = 0;  // virial or wall impulse up to there
};

}  // namespace carom::page
