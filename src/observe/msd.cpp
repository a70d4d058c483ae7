// Mean square displacement and self-diffusion.
//
// msd(t) = ⟨|r(t0 + t) − r(t0)|²⟩ over disks and origins t0, from unwrapped positions relative to the centre of mass
// along axes that conserve momentum. D(t) = msd/4t; the estimate `diffusion` is the slope of msd/4 (Einstein 1905)
// between the lags 8 and 15 × 2^l × interval, for the largest l that the run is 32 times as long as. Theory: Enskog
// × 1.02704 (theory.hpp). D of a two-dimensional fluid grows slowly with t and N (Alder and Wainwright, Phys. Rev. A 1,
// 18 (1970)).
#include <cmath>
#include <optional>

#include "carom/base/error.hpp"
#include "carom/observe/batches.hpp"
#include "carom/observe/theory.hpp"
#include "estimates.hpp"
#include "frame_spacing.hpp"
#include "kinds.hpp"
#include "past_frames.hpp"
#include "tables.hpp"

namespace carom {
namespace {

constexpr std::size_t kStandardLevels = 7;
constexpr std::size_t kStandardDisks = 10000;
constexpr std::uint64_t kLagsPerRun = 32;  // so much longer than a lag must a run be for `diffusion`

class Msd final : public Observable {
 public:
  Msd(const Subject& subject, double interval, std::size_t levels, std::size_t disks)
      : spacing_("msd", interval),
        disks_(evenly_chosen(subject.system.size(), disks)),
        past_(levels, 2 * disks_.size()),
        squares_(past_.lags()),
        fluid_(fluid_of_equal_disks(subject.system)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "msd"; }
  [[nodiscard]] double interval() const noexcept override { return spacing_.spacing(); }

  void on_frame(const System& system, const Frame& frame) override {
    spacing_.expect(frame.time);
    kT_ = temperature(system, frame);
    const std::vector<double> now = unwrapped(system, frame);
    past_.add(now, [&](std::size_t lag, std::span<const double> then) {
      const double sum =
          sum_in_four(now.size(), [&](std::size_t k) { return (now[k] - then[k]) * (now[k] - then[k]); });
      squares_.add(lag, sum / static_cast<double>(disks_.size()));
    });
    squares_.end_sample();
  }

  [[nodiscard]] Measurement result() const override {
    Measurement measurement;
    measurement.name = name();
    add_diffusion(measurement);
    measurement.tables.push_back(table());
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    spacing_.exchange(sums);
    sums.number("kT", kT_);
    past_.exchange(sums.below("past"));
    squares_.exchange(sums.below("squares"));
  }

 private:
  /// x and y of the disks followed, one after another.
  [[nodiscard]] std::vector<double> unwrapped(const System& system, const Frame& frame) const {
    const auto position = [&](std::size_t k) {
      return Vec2{frame.x[k] + static_cast<double>(frame.winding_x[k]) * system.box.size.x,
                  frame.y[k] + static_cast<double>(frame.winding_y[k]) * system.box.size.y};
    };
    double mass = 0;
    Vec2 moment;
    for (std::size_t k = 0; k < frame.size(); ++k) {
      mass += system.mass(k);
      moment = moment + system.mass(k) * position(k);
    }
    const Vec2 centre{system.box.conserves_momentum(0) ? moment.x / mass : 0,
                      system.box.conserves_momentum(1) ? moment.y / mass : 0};
    std::vector<double> positions;
    positions.reserve(2 * disks_.size());
    for (const std::size_t k : disks_) {
      const Vec2 r = position(k) - centre;
      positions.push_back(r.x);
      positions.push_back(r.y);
    }
    return positions;
  }

  [[nodiscard]] double time_of(std::size_t lag) const {
    return static_cast<double>(past_.lag(lag)) * spacing_.spacing();
  }

  void add_diffusion(Measurement& measurement) const {
    std::size_t level = 0;
    while (level + 1 < past_.levels() && past_.frames() >= kLagsPerRun * past_.lag(past_.last_of_level(level + 1))) {
      ++level;
    }
    const std::size_t from = past_.first_of_level(level);
    const std::size_t to = past_.last_of_level(level);
    const Batches::Value slope = squares_.of([&](const std::vector<double>& means) {
      return (means[to] - means[from]) / (4 * (time_of(to) - time_of(from)));
    });
    Estimate& diffusion = add_estimate(measurement, "diffusion", "length²/time", slope.value, slope.error);
    diffusion.samples = squares_.count(to);
    if (fluid_) {
      diffusion.theory = enskog_diffusion(*fluid_, kT_);
      diffusion.theory_source = "Enskog × 1.02704, infinite system";
    }
    if (past_.frames() < kLagsPerRun * past_.lag(to)) {
      diffusion.warnings.emplace_back(
          "the run is too short to tell the error: it is less than 32 times as long as a lag");
    }
    add_estimate(measurement, "diffusion_lag", "time", 0.5 * (time_of(from) + time_of(to)));
  }

  [[nodiscard]] Table table() const {
    Column time{"time", "time t", "time", {}};
    Column msd{"msd", "mean square displacement", "length²", {}};
    Column d{"diffusion", "D(t) = msd/4t", "length²/time", {}};
    Column theory{"diffusion_theory", "Enskog × 1.02704", "length²/time", {}};
    Column msd_error = error_column(msd);
    Column d_error = error_column(d);
    for (std::size_t lag = 1; lag < past_.lags() && squares_.count(lag) > 0; ++lag) {
      const Batches::Value value = squares_.mean(lag);
      const double t = time_of(lag);
      time.values.push_back(t);
      append(msd, msd_error, value);
      append(d, d_error, {value.value / (4 * t), value.error ? std::optional(*value.error / (4 * t)) : std::nullopt});
      if (fluid_) theory.values.push_back(enskog_diffusion(*fluid_, kT_));
    }
    Table table{.name = "msd", .title = "Mean square displacement", .columns = {time, msd, msd_error, d, d_error}};
    if (fluid_) table.columns.push_back(theory);
    table.logarithmic_x = table.logarithmic_y = true;
    return table;
  }

  FrameSpacing spacing_;
  const std::vector<std::size_t> disks_;
  PastFrames past_;
  Batches squares_;  // a column per lag
  const std::optional<EqualDisks> fluid_;
  double kT_ = 0;
};

}  // namespace

ObservableKind msd_kind() {
  return {
      .name = "msd",
      .summary = "mean square displacement and self-diffusion",
      .from_frames = true,
      .options =
          {{.name = "disks", .meaning = "follow so many disks at most", .standard = "10000", .whole = true, .least = 1},
           interval_option("half a mean free time or more"),
           {.name = "levels",
            .meaning = "the longest lag is 15 × 2^(levels − 1) intervals",
            .standard = "7",
            .whole = true,
            .least = 1,
            .most = 40}},
      .make = [](const Subject& subject, const ObservableOptions& options) -> std::unique_ptr<Observable> {
        return std::make_unique<Msd>(subject, frame_interval(options, subject, 1),
                                     options.count("levels", kStandardLevels), options.count("disks", kStandardDisks));
      }};
}

}  // namespace carom
