// Bond-orientational order: ψ6 of every disk with its Voronoi neighbours, of the whole system, and how it decays with
// distance.
//
// Ψ6 = Σ ψ6/N, its modulus averaged over frames; χ6 = N (⟨|Ψ6|²⟩ − ⟨|Ψ6|⟩²);
// g6(r) = ⟨Re ψ6(i)* ψ6(j)⟩ over the pairs at distance r: the correlation function already divided by g(r).
#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "carom/observe/batches.hpp"
#include "carom/observe/blocking.hpp"
#include "carom/order/local_order.hpp"
#include "carom/order/pairs.hpp"
#include "columns.hpp"
#include "estimates.hpp"
#include "kinds.hpp"

namespace carom {
namespace {

constexpr double kMeanFreeTimes = 32;
constexpr std::size_t kStandardBins = 200;
constexpr double kStandardRange = 16;  // in the largest diameter
constexpr double kShortestRange = 2;   // likewise

/// One number per frame.
struct Series {
  const char* name;
  const char* label;
  std::vector<double> values;
};

class Psi6 final : public Observable {
 public:
  Psi6(double range, std::size_t bins, double interval)
      : interval_(interval), range_(range), bins_(bins), correlation_(bins) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "psi6"; }
  [[nodiscard]] double interval() const noexcept override { return interval_; }

  void on_frame(const System& system, const Frame& frame) override {
    const LocalOrder order = local_order(system, frame);
    disks_ = static_cast<double>(frame.size());
    time_.values.push_back(frame.time);
    note_order(order);
    PairGrid(system.box, frame, range_).for_each([&](std::size_t i, std::size_t j, Vec2 r) {
      if (i != j) correlate(order.psi6[i], order.psi6[j], length(r));
    });
    correlation_.end_sample();
  }

  [[nodiscard]] Measurement result() const override {
    Measurement measurement;
    measurement.name = name();
    add_mean(measurement, "psi6_global", global_);
    add_susceptibility(measurement);
    add_mean(measurement, "psi6_local", local_);
    add_mean(measurement, "fivefold", five_);
    add_mean(measurement, "sixfold", six_);
    add_mean(measurement, "sevenfold", seven_);
    measurement.tables.push_back(correlation_table());
    measurement.tables.push_back(history());
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    sums.number("interval", interval_);
    sums.number("disks", disks_);
    for (Series* series : {&time_, &global_, &angle_, &local_, &five_, &six_, &seven_}) {
      sums.numbers(series->name, series->values);
    }
    correlation_.exchange(sums.below("correlation"));
  }

 private:
  void note_order(const LocalOrder& order) {
    std::complex<double> sum = 0;
    double moduli = 0;
    for (const std::complex<double>& psi : order.psi6) {
      sum += psi;
      moduli += std::abs(psi);
    }
    const auto share = [&](std::uint32_t neighbours) {
      return static_cast<double>(std::count(order.neighbours.begin(), order.neighbours.end(), neighbours)) / disks_;
    };
    global_.values.push_back(std::abs(sum) / disks_);
    angle_.values.push_back(std::arg(sum) / 6);
    local_.values.push_back(moduli / disks_);
    five_.values.push_back(share(5));
    six_.values.push_back(share(6));
    seven_.values.push_back(share(7));
  }

  void correlate(std::complex<double> a, std::complex<double> b, double r) {
    const auto bin = static_cast<std::size_t>(r / range_ * static_cast<double>(bins_));
    if (bin < bins_) correlation_.add(bin, a.real() * b.real() + a.imag() * b.imag());
  }

  void add_mean(Measurement& measurement, const char* name, const Series& series) const {
    Blocking blocking;
    for (const double value : series.values) blocking.add(value);
    add_estimate(measurement, name, "", blocking, interval_);
  }

  void add_susceptibility(Measurement& measurement) const {
    Batches moments(2);
    for (const double value : global_.values) {
      moments.add(0, value);
      moments.add(1, value * value);
      moments.end_sample();
    }
    const Batches::Value chi =
        moments.of([this](const std::vector<double>& m) { return disks_ * (m[1] - m[0] * m[0]); });
    add_estimate(measurement, "susceptibility", "", chi.value, chi.error).samples = moments.samples();
  }

  [[nodiscard]] Table correlation_table() const;
  [[nodiscard]] Table history() const;

  double interval_;
  double range_;
  std::size_t bins_;

  double disks_ = 0;
  Series time_{"time", "time", {}};
  Series global_{"psi6", "global order |Ψ6|", {}};
  Series angle_{"angle", "angle of the lattice", {}};
  Series local_{"psi6_local", "mean of |ψ6|", {}};
  Series five_{"fivefold", "share of disks with 5 neighbours", {}};
  Series six_{"sixfold", "share of disks with 6 neighbours", {}};
  Series seven_{"sevenfold", "share of disks with 7 neighbours", {}};
  Batches correlation_;  // Re ψ6* ψ6 of pairs, by bin
};

/// Distances at which there were no pairs are left out.
Table Psi6::correlation_table() const {
  Table table{.name = "g6",
              .title = "Correlation of bond-orientational order",
              .columns = {{"r", "distance r", "length", {}}},
              .logarithmic_x = true,
              .logarithmic_y = true};
  std::vector<Batches::Value> found;
  for (std::size_t bin = 0; bin < bins_; ++bin) {
    if (correlation_.count(bin) == 0) continue;
    table.columns[0].values.push_back(range_ * (static_cast<double>(bin) + 0.5) / static_cast<double>(bins_));
    found.push_back(correlation_.mean(bin));
  }
  append_columns(table, {"g6", "correlation of orientation g6(r)", "", {}}, found);
  return table;
}

Table Psi6::history() const {
  Table table{.name = "psi6", .title = "Bond-orientational order", .columns = {}};
  for (const Series* series : {&time_, &global_, &angle_, &local_, &five_, &six_, &seven_}) {
    const char* const unit = series == &time_ ? "time" : series == &angle_ ? "rad" : "";
    table.columns.push_back({series->name, series->label, unit, series->values});
  }
  return table;
}

/// So many diameters, but not beyond half the box, where images repeat one another.
double standard_range(const System& system) {
  const Box& box = system.box;
  const double diameter = 2 * system.largest_radius();
  double range = kStandardRange * diameter;
  if (box.boundary[0] != Boundary::open) range = std::min(range, box.size.x / 2);
  if (box.boundary[1] != Boundary::open) range = std::min(range, box.size.y / 2);
  return std::max(range, kShortestRange * diameter);
}

}  // namespace

ObservableKind psi6_kind() {
  return {.name = "psi6",
          .summary = "bond-orientational order ψ6 of Voronoi neighbours, global and local, and its correlation g6(r)",
          .from_frames = true,
          .options = {interval_option("32 mean free times"),
                      {.name = "r_max",
                       .meaning = "largest distance of g6",
                       .standard = "16 diameters, at most half the box",
                       .least = 1e-300},
                      {.name = "bins",
                       .meaning = "number of bins of g6",
                       .standard = "200",
                       .whole = true,
                       .least = 1,
                       .most = 1e5}},
          .make = [](const Subject& subject, const ObservableOptions& options) -> std::unique_ptr<Observable> {
            const double range = options.number("r_max", standard_range(subject.system));
            check_pair_range("r_max of psi6", subject.system.box, range);
            return std::make_unique<Psi6>(range, options.count("bins", kStandardBins),
                                          frame_interval(options, subject, kMeanFreeTimes));
          }};
}

}  // namespace carom
