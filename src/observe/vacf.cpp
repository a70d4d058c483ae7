// Velocity autocorrelation, its slope at the start, and self-diffusion after Green and Kubo.
//
// C(t) = ⟨v(t0)·v(t0 + t)⟩/⟨v²⟩ over disks and origins t0, velocities relative to the drift.
// D(t) = ½ ∫ ⟨v(0)·v(t')⟩ dt' from 0 to t (Green 1954, Kubo 1957), by the trapezoidal rule with its end correction at
// 0.
//
// Slope at 0, for equal disks. A collision with impulse J = (1+e) m v_n/2 has v_i·Δv_i + v_j·Δv_j = −(J/m) v_n =
// −2 J²/((1+e) m²), v_n the velocity of approach. So C'(0) = −Σ 2 J²/((1+e) m²)/(t Σ v²): exact for the collisions
// seen. In equilibrium (e = 1) there are NΓ/2 collisions per time, ⟨v_n²⟩ over them is 4 kT/m × f/(f+1), and Σ v² = f
// kT/m: then C'(0) = −Γ × 2N/(f+1), which is −Γ for large N.
#include <cmath>
#include <optional>

#include "carom/base/error.hpp"
#include "carom/observe/batches.hpp"
#include "carom/observe/blocking.hpp"
#include "carom/observe/theory.hpp"
#include "estimates.hpp"
#include "frame_spacing.hpp"
#include "kinds.hpp"
#include "motion.hpp"
#include "past_frames.hpp"
#include "tables.hpp"

namespace carom {
namespace {

constexpr std::size_t kStandardLevels = 5;
constexpr std::size_t kStandardDisks = 10000;
constexpr double kSmoothEnough = 0.6;      // C between two frames
constexpr std::uint64_t kLagsPerRun = 32;  // so much longer than a lag must a run be for `diffusion`

class Vacf final : public Observable {
 public:
  Vacf(const Subject& subject, double interval, std::size_t levels, std::size_t disks)
      : from_frames_(subject.spacing.has_value()),
        spacing_("vacf", interval),
        disks_(evenly_chosen(subject.system.size(), disks)),
        past_(levels, 2 * disks_.size()),
        products_(past_.lags()),
        number_(static_cast<double>(subject.system.size())),
        freedom_(degrees_of_freedom(subject.system)),
        one_kind_(subject.system.species.size() == 1),
        fluid_(fluid_of_equal_disks(subject.system)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "vacf"; }
  [[nodiscard]] double interval() const noexcept override { return spacing_.spacing(); }
  [[nodiscard]] bool wants_collisions() const noexcept override { return true; }

  void on_window(const WindowRecord& window) override {
    if (!one_kind_) return;
    const double squares =
        0.5 * (sum_of_squares(window.system, window.before.disks) + sum_of_squares(window.system, window.after.disks));
    if (!(squares > 0)) return;
    const Physics& physics = window.system.physics;
    const double mass = window.system.mass(0);
    double lost = 0;  // −Σ v·Δv
    double collisions = 0;
    for (const Collision& collision : window.collisions) {
      const double kick = collision.impulse / mass;
      const bool wall = is_wall(collision.j);
      lost += wall ? kick * kick / (1 + physics.wall_restitution) : 2 * kick * kick / (1 + physics.restitution);
      collisions += wall ? 0 : 1;
    }
    const double duration = window.before.clock.length;
    slopes_.add(-lost / (squares * duration));
    rates_.add(2 * collisions / (number_ * duration));
    time_ += duration;
  }

  void on_frame(const System& system, const Frame& frame) override {
    spacing_.expect(frame.time);
    kT_ = temperature(system, frame);
    const Vec2 drift = drift_velocity(system, frame);
    std::vector<double> now;
    now.reserve(2 * disks_.size());
    for (const std::size_t k : disks_) {
      now.push_back(frame.vx[k] - drift.x);
      now.push_back(frame.vy[k] - drift.y);
    }
    past_.add(now, [&](std::size_t lag, std::span<const double> then) {
      const double sum = sum_in_four(now.size(), [&](std::size_t k) { return now[k] * then[k]; });
      products_.add(lag, sum / static_cast<double>(disks_.size()));
    });
    products_.end_sample();
  }

  [[nodiscard]] Measurement result() const override {
    Measurement measurement;
    measurement.name = name();
    if (one_kind_ && !from_frames_) add_slope(measurement);
    add_diffusion(measurement);
    measurement.tables = {correlation_table(), diffusion_table()};
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    spacing_.exchange(sums);
    sums.number("kT", kT_);
    sums.number("time", time_);
    past_.exchange(sums.below("past"));
    products_.exchange(sums.below("products"));
    slopes_.exchange(sums.below("slopes"));
    rates_.exchange(sums.below("rates"));
  }

 private:
  static double sum_of_squares(const System& system, const Frame& frame) {
    const Vec2 drift = drift_velocity(system, frame);
    double sum = 0;
    for (std::size_t k = 0; k < frame.size(); ++k) {
      const Vec2 v = frame.velocity(k) - drift;
      sum += dot(v, v);
    }
    return sum;
  }

  [[nodiscard]] double time_of(std::size_t lag) const {
    return static_cast<double>(past_.lag(lag)) * spacing_.spacing();
  }

  void add_slope(Measurement& measurement) const {
    const Blocking::Result rate = rates_.result();
    const double spacing = time_ / static_cast<double>(rate.samples);
    Estimate& slope = add_estimate(measurement, "initial_slope", "1/time", slopes_, spacing);
    if (!fluid_) return;
    slope.theory = -rate.mean * 2 * number_ / (freedom_ + 1);
    slope.theory_source = "−Γ × 2N/(f+1), Γ as measured";
  }

  /// ½ ∫ from 0 to the lag of this number. The end correction needs the slope at 0, which the collisions tell.
  [[nodiscard]] double integral_to(std::size_t last, const std::vector<double>& means) const {
    double sum = 0;
    for (std::size_t lag = 1; lag <= last; ++lag) {
      sum += 0.5 * (means[lag] + means[lag - 1]) * (time_of(lag) - time_of(lag - 1));
    }
    const Blocking::Result slope = slopes_.result();
    const double step = spacing_.spacing();
    if (slope.samples > 0) sum += means[0] * slope.mean * step * step / 12;
    return 0.5 * sum;
  }

  [[nodiscard]] std::size_t last_lag() const {
    std::size_t last = 1;
    while (last + 1 < past_.lags() && past_.frames() >= kLagsPerRun * past_.lag(last + 1)) ++last;
    return last;
  }

  void add_diffusion(Measurement& measurement) const {
    const std::size_t last = last_lag();
    const Batches::Value integral =
        products_.of([&](const std::vector<double>& means) { return integral_to(last, means); });
    Estimate& diffusion = add_estimate(measurement, "diffusion", "length²/time", integral.value, integral.error);
    diffusion.samples = products_.count(last);
    if (fluid_) {
      diffusion.theory = enskog_diffusion(*fluid_, kT_);
      diffusion.theory_source = "Enskog × 1.02704, infinite system";
    }
    if (last + 1 < past_.lags()) {
      diffusion.warnings.emplace_back(
          "the run is too short for the longest lags: this is the integral up to diffusion_lag");
    }
    if (products_.mean(1).value < kSmoothEnough * products_.mean(0).value) {
      diffusion.warnings.emplace_back("velocities change much from frame to frame: the integral is not accurate");
    }
    add_estimate(measurement, "diffusion_lag", "time", time_of(last));
  }

  [[nodiscard]] Table correlation_table() const {
    Column time{"time", "time t", "time", {}};
    Column c{"vacf", "velocity autocorrelation C(t)", "", {}};
    Column theory{"vacf_theory", "Enskog: exp(−Γt)", "", {}};
    Column error = error_column(c);
    for (std::size_t lag = 0; lag < past_.lags() && products_.count(lag) > 0; ++lag) {
      time.values.push_back(time_of(lag));
      append(c, error, products_.of([lag](const std::vector<double>& means) { return means[lag] / means[0]; }));
      if (fluid_) theory.values.push_back(std::exp(-enskog_rate(*fluid_, kT_) * time_of(lag)));
    }
    Table table{.name = "vacf", .title = "Velocity autocorrelation", .columns = {time, c, error}};
    if (fluid_) table.columns.push_back(theory);
    return table;
  }

  [[nodiscard]] Table diffusion_table() const {
    Column time{"time", "time t", "time", {}};
    Column d{"diffusion", "D(t) = ½ ∫ C", "length²/time", {}};
    Column theory{"diffusion_theory", "Enskog × 1.02704", "length²/time", {}};
    Column error = error_column(d);
    for (std::size_t lag = 1; lag < past_.lags() && products_.count(lag) > 0; ++lag) {
      time.values.push_back(time_of(lag));
      append(d, error, products_.of([&](const std::vector<double>& means) { return integral_to(lag, means); }));
      if (fluid_) theory.values.push_back(enskog_diffusion(*fluid_, kT_));
    }
    Table table{
        .name = "green_kubo", .title = "Diffusion from the velocity autocorrelation", .columns = {time, d, error}};
    if (fluid_) table.columns.push_back(theory);
    table.logarithmic_x = true;
    return table;
  }

  const bool from_frames_;
  FrameSpacing spacing_;
  const std::vector<std::size_t> disks_;
  PastFrames past_;
  Batches products_;  // a column per lag: ⟨v·v⟩
  const double number_;
  const double freedom_;
  const bool one_kind_;
  const std::optional<EqualDisks> fluid_;
  double kT_ = 0;
  double time_ = 0;  // of windows
  // One sample per window.
  Blocking slopes_;
  Blocking rates_;
};

}  // namespace

ObservableKind vacf_kind() {
  return {
      .name = "vacf",
      .summary = "velocity autocorrelation, its initial slope, and self-diffusion",
      .from_frames = true,
      .options =
          {{.name = "disks", .meaning = "follow so many disks at most", .standard = "10000", .whole = true, .least = 1},
           interval_option("an eighth of a mean free time or more"),
           {.name = "levels",
            .meaning = "the longest lag is 15 × 2^(levels − 1) intervals",
            .standard = "5",
            .whole = true,
            .least = 1,
            .most = 40}},
      .make = [](const Subject& subject, const ObservableOptions& options) -> std::unique_ptr<Observable> {
        return std::make_unique<Vacf>(subject, frame_interval(options, subject, 0.25),
                                      options.count("levels", kStandardLevels), options.count("disks", kStandardDisks));
      }};
}

}  // namespace carom
