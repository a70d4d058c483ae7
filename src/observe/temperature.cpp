// Kinetic temperature over time, and the cooling of granular gases.
//
// kT = 2E/f, velocities relative to the drift. Where restitution is below 1, Haff's law (J. Fluid Mech. 134, 401
// (1983)): T = T0/(1 + t/τ)², 1/τ = (1 − e²) Γ0/4 with the collision rate Γ0 at T0 (here Enskog's), until clusters
// form. The fit: least squares of 1/√T against t while T is at least fit_down_to × the first temperature. Sampled at
// the ends of windows; where the gas cools, 16 times in each window, so that samples follow its slowing down.
//
// Error of 1/τ: the n collisions of the fit take away energies in proportion to v_n², which is distributed
// exponentially; if they are independent, their number and sum fluctuate by √(2/n) of the sum (a compound Poisson
// process).
#include <cmath>
#include <optional>

#include "carom/base/error.hpp"
#include "carom/observe/batches.hpp"
#include "carom/observe/blocking.hpp"
#include "carom/observe/replay.hpp"
#include "carom/observe/theory.hpp"
#include "estimates.hpp"
#include "kinds.hpp"
#include "time_series.hpp"

namespace carom {
namespace {

constexpr double kStandardFit = 0.25;
constexpr int kSamplesPerWindow = 16;  // where the gas cools: it does so within a window

/// Intercept and slope of y = a + b x from the means of x, x², y, x y.
struct Line {
  double intercept = 0;
  double slope = 0;
};

Line fitted(const std::vector<double>& means) {
  const double variance = means[1] - means[0] * means[0];
  const double slope = (means[3] - means[0] * means[2]) / variance;
  return {means[2] - slope * means[0], slope};
}

class Temperature final : public Observable {
 public:
  Temperature(const Subject& subject, double fit_down_to)
      : fit_down_to_(fit_down_to),
        restitution_(subject.system.physics.restitution),
        cools_(!subject.system.physics.elastic()) {
    const Box& box = subject.system.box;
    if (cools_ && box.periodic(0) && box.periodic(1)) gas_ = gas_of_equal_disks(subject.system);
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "temperature"; }
  [[nodiscard]] bool wants_collisions() const noexcept override { return cools_; }

  void on_window(const WindowRecord& window) override {
    if (!cools_) {
      sample(window.system, window.after.disks);
      return;
    }
    WindowReplay replay(window);
    const Clock& clock = window.before.clock;
    auto collision = window.collisions.begin();
    for (int k = 0; k < kSamplesPerWindow; ++k) {
      const double offset = k * (clock.length / kSamplesPerWindow);
      for (; collision != window.collisions.end() && collision->time < offset; ++collision) ++collisions_;
      sample(window.system, replay.at(clock.start + offset));
    }
    collisions_ += static_cast<std::uint64_t>(window.collisions.end() - collision);
  }
  void on_frame(const System& system, const Frame& frame) override { sample(system, frame); }

  [[nodiscard]] Measurement result() const override {
    Measurement measurement;
    measurement.name = name();
    if (cools_) {
      add_cooling(measurement);
    } else {
      const auto samples = static_cast<double>(samples_.result().samples);
      add_estimate(measurement, "kT", "energy", samples_, (last_ - start_) / samples);
    }
    measurement.tables.push_back(table());
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    sums.number("started", started_);
    sums.number("start", start_);
    sums.number("first", first_);
    sums.number("last", last_);
    sums.number("collisions", collisions_);
    sums.number("fitted_collisions", fitted_collisions_);
    samples_.exchange(sums.below("samples"));
    series_.exchange(sums.below("series"));
    fit_.exchange(sums.below("fit"));
  }

 private:
  void sample(const System& system, const Frame& frame) {
    const double kT = temperature(system, frame);
    if (!started_) {
      started_ = true;
      start_ = frame.time;
      first_ = kT;
    }
    last_ = frame.time;
    samples_.add(kT);
    series_.add(frame.time, kT);
    if (!cools_ || !(kT > 0) || kT < fit_down_to_ * first_) return;
    const double x = frame.time - start_;
    const double y = 1 / std::sqrt(kT);
    fit_.add(0, x);
    fit_.add(1, x * x);
    fit_.add(2, y);
    fit_.add(3, x * y);
    fit_.end_sample();
    fitted_collisions_ = collisions_;
  }

  /// 1/τ by theory for a start at kT.
  [[nodiscard]] std::optional<double> theoretical_rate(double kT) const {
    if (!gas_ || !(kT > 0)) return std::nullopt;
    return (1 - restitution_ * restitution_) * enskog_rate(*gas_, kT) / 4;
  }

  void add_cooling(Measurement& measurement) const {
    const Batches::Value initial = fit_.of([](const std::vector<double>& means) {
      const double intercept = fitted(means).intercept;
      return 1 / (intercept * intercept);
    });
    const Batches::Value rate = fit_.of([](const std::vector<double>& means) {
      const Line line = fitted(means);
      return line.slope / line.intercept;
    });
    add_estimate(measurement, "initial_kT", "energy", initial.value, initial.error).samples = fit_.samples();
    Estimate& cooling = add_estimate(measurement, "cooling_rate", "1/time", rate.value);
    if (fitted_collisions_ > 0) cooling.error = rate.value * std::sqrt(2 / static_cast<double>(fitted_collisions_));
    cooling.samples = fit_.samples();
    cooling.theory = theoretical_rate(initial.value);
    if (cooling.theory) cooling.theory_source = "Haff 1983, Enskog's collision rate";
  }

  [[nodiscard]] Table table() const {
    Column time{"time", "time t", "time", series_.times()};
    Column kT{"kT", "kinetic temperature kT", "energy", series_.values()};
    Table table{.name = "temperature", .title = "Temperature", .columns = {time, kT}};
    const std::optional<double> rate = theoretical_rate(first_);
    if (!rate) return table;
    Column theory{"kT_theory", "Haff's law", "energy", {}};
    for (const double t : series_.times()) {
      const double factor = 1 + (t - start_) * *rate;
      theory.values.push_back(first_ / (factor * factor));
    }
    table.columns.push_back(theory);
    table.logarithmic_y = true;
    return table;
  }

  const double fit_down_to_;
  const double restitution_;
  const bool cools_;
  std::optional<EqualDisks> gas_;

  bool started_ = false;
  double start_ = 0;                     // time of the first sample
  double first_ = 0;                     // its kT
  double last_ = 0;                      // time of the last sample
  std::uint64_t collisions_ = 0;         // since the first sample
  std::uint64_t fitted_collisions_ = 0;  // up to the last one that is fitted
  Blocking samples_;
  TimeSeries series_;
  Batches fit_{4};  // of x = t − start, x², y = 1/√kT, x y
};

}  // namespace

ObservableKind temperature_kind() {
  return {.name = "temperature",
          .summary = "kinetic temperature over time, and Haff's law where restitution is below 1",
          .from_frames = true,
          .options = {{.name = "fit_down_to",
                       .meaning = "fit Haff's law down to this share of the first temperature",
                       .standard = "0.25",
                       .whole = false,
                       .least = 0,
                       .most = 1}},
          .make = [](const Subject& subject, const ObservableOptions& options) -> std::unique_ptr<Observable> {
            if (!(degrees_of_freedom(subject.system) > 0)) {
              throw Error("temperature: a single disk in a periodic box has none");
            }
            return std::make_unique<Temperature>(subject, options.number("fit_down_to", kStandardFit));
          }};
}

}  // namespace carom
