// Pressure from the virial of collisions, or from the impulses on the walls.
//
// Periodic: Z = βP/ρ = 1 + W/(2 N kT t) with W = Σ |J| σ over the collisions in the time t (σ the distance of contact):
// the virial theorem for hard disks. kT = 2E/f with f = 2N − 2 makes this the canonical value exactly.
// With walls: βP = Σ |J| / (length of all walls × t × kT), Z = βP A/N.
// Each window is a sample; values are sums over all windows divided by the time.
#include <cmath>
#include <optional>

#include "carom/base/error.hpp"
#include "carom/observe/blocking.hpp"
#include "carom/observe/theory.hpp"
#include "estimates.hpp"
#include "kinds.hpp"

namespace carom {
namespace {

/// Σ after − before, in id order.
double gained(const std::vector<double>& before, const std::vector<double>& after) {
  double sum = 0;
  for (std::size_t k = 0; k < after.size(); ++k) sum += after[k] - before[k];
  return sum;
}

class Pressure final : public Observable {
 public:
  explicit Pressure(const System& system)
      : virial_(system.box.periodic(0) && system.box.periodic(1)),
        disks_(static_cast<double>(system.size())),
        area_(system.box.size.x * system.box.size.y),
        walls_(2 * ((system.box.reflecting(0) ? system.box.size.y : 0) +
                    (system.box.reflecting(1) ? system.box.size.x : 0))),
        elastic_(system.physics.elastic()),
        diameter_(system.species.size() == 1 ? std::optional(2 * system.radius(0)) : std::nullopt),
        fluid_(fluid_of_equal_disks(system)),
        two_(two_disks(system)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "pressure"; }

  void on_window(const WindowRecord& window) override {
    const double duration = window.before.clock.length;
    const double kT = temperature_of(window);
    if (!(kT > 0)) return;
    // Z times the duration.
    double sum = 0;
    if (virial_) {
      const double virial = gained(window.books_before.virial_of, window.books.virial_of);
      sum = duration + virial / (2 * disks_ * kT);
    } else {
      const double impulse = gained(window.books_before.wall_impulse_of, window.books.wall_impulse_of);
      sum = impulse * area_ / (walls_ * disks_ * kT);
    }
    sum_ += sum;
    time_ += duration;
    samples_.add(sum / duration);
  }

  [[nodiscard]] Measurement result() const override {
    Measurement measurement;
    measurement.name = name();
    const auto windows = static_cast<double>(samples_.result().samples);
    Estimate z = add_estimate(measurement, "Z", "", samples_, time_ / windows, sum_ / time_);
    if (fluid_) {
      z.theory = finite_compressibility(*fluid_);
      z.theory_source = source_of_compressibility(*fluid_);
    }
    if (two_) {
      z.theory = 1 + two_->excess;
      z.theory_source = "exact";
    }
    const double density = disks_ / area_;
    measurement.estimates = {z, scaled(z, "pressure", "1/length²", density)};
    if (diameter_) measurement.estimates.push_back(scaled(z, "pressure_d2", "", density * *diameter_ * *diameter_));
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    sums.number("sum", sum_);
    sums.number("time", time_);
    sums.number("kT", kT_);
    samples_.exchange(sums.below("samples"));
  }

 private:
  /// In an elastic system the same for all windows but for rounding: computed once.
  double temperature_of(const WindowRecord& window) {
    if (elastic_ && kT_ > 0) return kT_;
    kT_ = temperature(window.system, window.after.disks);
    if (!elastic_) kT_ = 0.5 * (kT_ + temperature(window.system, window.before.disks));
    return kT_;
  }

  const bool virial_;
  const double disks_;
  const double area_;
  const double walls_;  // length of all walls
  const bool elastic_;
  const std::optional<double> diameter_;
  const std::optional<EqualDisks> fluid_;
  const std::optional<TwoDisks> two_;

  double sum_ = 0;    // ∫ Z dt
  double kT_ = 0;     // of the last window
  double time_ = 0;   // measured
  Blocking samples_;  // Z of each window
};

}  // namespace

ObservableKind pressure_kind() {
  return {.name = "pressure",
          .summary = "pressure from the virial of collisions, or on the walls",
          .from_frames = false,
          .options = {},
          .make = [](const Subject& subject, const ObservableOptions&) -> std::unique_ptr<Observable> {
            const Box& box = subject.system.box;
            if (box.boundary[0] == Boundary::open || box.boundary[1] == Boundary::open) {
              throw Error("pressure: the plane is open, nothing keeps the disks together");
            }
            return std::make_unique<Pressure>(subject.system);
          }};
}

}  // namespace carom
