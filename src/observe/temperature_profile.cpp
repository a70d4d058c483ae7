// Kinetic temperature and density across the box.
//
// kT(x) = ⟨½ m v²⟩ × 2N/f over the disks whose centres lie in a strip, velocities relative to the drift: the mean over
// all disks is kT = 2E/f. Density: disks per area of the strip. Sampled at the ends of windows.
#include <array>
#include <cmath>
#include <string>

#include "carom/base/error.hpp"
#include "carom/observe/batches.hpp"
#include "kinds.hpp"
#include "motion.hpp"
#include "tables.hpp"

namespace carom {
namespace {

constexpr std::size_t kStandardBins = 40;

class TemperatureProfile final : public Observable {
 public:
  TemperatureProfile(const System& system, std::size_t bins, bool from_frames)
      : bins_(bins),
        from_frames_(from_frames),
        scale_(2 * static_cast<double>(system.size()) / degrees_of_freedom(system)),
        size_(system.box.size),
        known_{system.box.boundary[0] != Boundary::open, system.box.boundary[1] != Boundary::open},
        kT_(2 * bins),
        density_(2 * bins) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "temperature_profile"; }

  void on_window(const WindowRecord& window) override { sample(window.system, window.after.disks); }
  void on_frame(const System& system, const Frame& frame) override {
    if (from_frames_) sample(system, frame);
  }

  [[nodiscard]] Measurement result() const override {
    Measurement measurement;
    measurement.name = name();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!known_[axis]) continue;
      measurement.tables.push_back(
          profile("temperature_profile", axis, kT_, {"kT", "kinetic temperature kT", "energy"}));
      measurement.tables.push_back(profile("density_profile", axis, density_, {"density", "density", "1/length²"}));
    }
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    kT_.exchange(sums.below("kT"));
    density_.exchange(sums.below("density"));
  }

 private:
  void sample(const System& system, const Frame& frame) {
    const Vec2 drift = drift_velocity(system, frame);
    std::vector<double> disks(2 * bins_);
    for (std::size_t k = 0; k < frame.size(); ++k) {
      const Vec2 v = frame.velocity(k) - drift;
      const double energy = 0.5 * scale_ * system.mass(k) * dot(v, v);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (!known_[axis]) continue;
        const std::size_t column = axis * bins_ + bin_of(frame, k, axis);
        kT_.add(column, energy);
        ++disks[column];
      }
    }
    const double strip = size_.x * size_.y / static_cast<double>(bins_);
    for (std::size_t column = 0; column < disks.size(); ++column) density_.add(column, disks[column] / strip);
    kT_.end_sample();
    density_.end_sample();
  }

  [[nodiscard]] std::size_t bin_of(const Frame& frame, std::size_t k, std::size_t axis) const {
    const double share = axis == 0 ? frame.x[k] / size_.x : frame.y[k] / size_.y;
    const double bin = std::floor(share * static_cast<double>(bins_));
    return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(bins_ - 1)));
  }

  [[nodiscard]] Table profile(const std::string& what, std::size_t axis, const Batches& batches, Column y) const {
    const std::string letter = axis == 0 ? "x" : "y";
    const double width = (axis == 0 ? size_.x : size_.y) / static_cast<double>(bins_);
    Table table{.name = what + '_' + letter, .title = y.label + " along " + letter, .columns = {}};
    Column place{letter, letter, "length", {}};
    Column error = error_column(y);
    for (std::size_t bin = 0; bin < bins_; ++bin) {
      const Batches::Value value = batches.mean(axis * bins_ + bin);
      place.values.push_back((static_cast<double>(bin) + 0.5) * width);
      append(y, error, value);
    }
    table.columns = {place, y, error};
    return table;
  }

  const std::size_t bins_;
  const bool from_frames_;
  const double scale_;
  const Vec2 size_;
  const std::array<bool, 2> known_;  // axes along which the box ends

  // Columns: the strips along x, then those along y.
  Batches kT_;
  Batches density_;
};

}  // namespace

ObservableKind temperature_profile_kind() {
  return {.name = "temperature_profile",
          .summary = "kinetic temperature and density across the box",
          .from_frames = true,
          .options = {{.name = "bins",
                       .meaning = "strips along each axis",
                       .standard = "40",
                       .whole = true,
                       .least = 1,
                       .most = 1e5}},
          .make = [](const Subject& subject, const ObservableOptions& options) -> std::unique_ptr<Observable> {
            const Box& box = subject.system.box;
            if (box.boundary[0] == Boundary::open || box.boundary[1] == Boundary::open) {
              throw Error("temperature_profile: the plane is open, it cannot be cut into strips");
            }
            if (!(degrees_of_freedom(subject.system) > 0)) {
              throw Error("temperature_profile: a single disk in a periodic box has no temperature");
            }
            return std::make_unique<TemperatureProfile>(subject.system, options.count("bins", kStandardBins),
                                                        subject.spacing.has_value());
          }};
}

}  // namespace carom
