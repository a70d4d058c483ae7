// Collision rate, mean free time and mean free path.
//
// Γ = 2 × collisions of two disks / (N t): each collision is one of two disks. Mean free time 1/Γ, mean free path
// ⟨|v|⟩/Γ, speeds relative to the drift, at the ends of windows. Each window is a sample. Theory: Enskog's Γ = 2 ρ d g
// √(π kT/m) with g from Kolafa and Rottner's Z, times the factor C of a system with f degrees of freedom (theory.hpp);
// the mean free path of N disks without total momentum is then √(1 − 1/N)/(2√2 ρ d g).
#include <cmath>
#include <optional>

#include "carom/observe/blocking.hpp"
#include "carom/observe/theory.hpp"
#include "estimates.hpp"
#include "kinds.hpp"
#include "motion.hpp"

namespace carom {
namespace {

class Rate final : public Observable {
 public:
  explicit Rate(const System& system)
      : disks_(static_cast<double>(system.size())),
        freedom_(degrees_of_freedom(system)),
        mass_(system.mass(0)),
        fluid_(fluid_of_equal_disks(system)),
        two_(two_disks(system)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "rate"; }

  void on_window(const WindowRecord& window) override {
    const double duration = window.before.clock.length;
    const auto collisions = static_cast<double>(window.books.collisions - window.books_before.collisions);
    collisions_ += collisions;
    time_ += duration;
    rates_.add(2 * collisions / (disks_ * duration));
    speeds_.add(mean_speed(window.system, window.after.disks));
    if (!(kT_ > 0)) kT_ = temperature(window.system, window.after.disks);
  }

  [[nodiscard]] Measurement result() const override {
    Measurement measurement;
    measurement.name = name();
    const double spacing = time_ / static_cast<double>(rates_.result().samples);
    Estimate rate =
        add_estimate(measurement, "collision_rate", "1/time", rates_, spacing, 2 * collisions_ / (disks_ * time_));
    if (fluid_) {
      rate.theory = finite_rate(*fluid_, kT_, freedom_);
      rate.theory_source = "Enskog, g of " + std::string(source_of_compressibility(*fluid_));
    }
    if (two_) {
      rate.theory = two_->rate_per * std::sqrt(4 * kT_ / mass_);
      rate.theory_source = "exact";
    }
    measurement.estimates = {rate};
    if (!(collisions_ > 0)) return measurement;
    measurement.estimates.push_back(mean_free_time(rate));
    measurement.estimates.push_back(mean_free_path(rate));
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    sums.number("collisions", collisions_);
    sums.number("time", time_);
    sums.number("kT", kT_);
    rates_.exchange(sums.below("rates"));
    speeds_.exchange(sums.below("speeds"));
  }

 private:
  /// 1/Γ.
  [[nodiscard]] Estimate mean_free_time(const Estimate& rate) const {
    Estimate time = scaled(rate, "mean_free_time", "time", 1 / (rate.value * rate.value));
    time.value = 1 / rate.value;
    if (rate.theory) time.theory = 1 / *rate.theory;
    return time;
  }

  /// ⟨|v|⟩/Γ.
  [[nodiscard]] Estimate mean_free_path(const Estimate& rate) const {
    const Blocking::Result speed = speeds_.result();
    Estimate path = mean_free_time(rate);
    path.name = "mean_free_path";
    path.unit = "length";
    path.value = speed.mean / rate.value;
    if (path.error && speed.error) *path.error = std::hypot(speed.mean * *path.error, *speed.error / rate.value);
    path.theory.reset();
    if (fluid_) {
      const double g = finite_contact_value(*fluid_);
      path.theory = std::sqrt((1 - 1 / disks_) / 8) / (fluid_->number_density * fluid_->diameter * g);
    }
    return path;
  }

  const double disks_;
  const double freedom_;
  const double mass_;
  const std::optional<EqualDisks> fluid_;
  const std::optional<TwoDisks> two_;

  double collisions_ = 0;
  double time_ = 0;
  double kT_ = 0;  // of the first window: theory is for elastic systems, where it stays
  // One sample per window.
  Blocking rates_;
  Blocking speeds_;
};

}  // namespace

ObservableKind rate_kind() {
  return {.name = "rate",
          .summary = "collision rate, mean free time and mean free path",
          .from_frames = false,
          .options = {},
          .make = [](const Subject& subject, const ObservableOptions&) -> std::unique_ptr<Observable> {
            return std::make_unique<Rate>(subject.system);
          }};
}

}  // namespace carom
