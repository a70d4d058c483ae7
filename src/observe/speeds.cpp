// Speeds against Maxwell's distribution, their fourth moment, and Boltzmann's H over time.
//
// Speeds are relative to the drift and in units of √(kT/m) with the frame's own kT: c. Maxwell: f(c) = c exp(−c²/2).
// A system of N disks and given energy has P(> c) = (1 − c²/(q f))^((f−2)/2), f degrees of freedom, q = 1 − (conserved
// axes)/2N, which tends to Maxwell's for large N; the Kolmogorov–Smirnov distance is taken to this one. Its p-value
// counts in that the energy of every frame is given (kolmogorov.hpp). ⟨v⁴⟩/⟨v²⟩² is 2f/(f+2), or 2(N−1)/N in a periodic
// box. Samples are so many contacts per disk apart that velocities have been forgotten: they decay like exp(−contacts)
// at first.
//
// H = ∫ f ln f d²v in the same units: −(1 + ln 2π) for Maxwell's distribution, more for any other of the same energy.
// From a histogram of c²/2 in bins of equal area of the velocity plane, less (bins in use − 1)/2N (Miller 1955).
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "carom/base/error.hpp"
#include "carom/observe/batches.hpp"
#include "carom/observe/blocking.hpp"
#include "estimates.hpp"
#include "kinds.hpp"
#include "kolmogorov.hpp"
#include "motion.hpp"
#include "tables.hpp"
#include "time_series.hpp"

namespace carom {
namespace {

constexpr double kStandardContacts = 8;
// All speeds together, fine enough for the Kolmogorov–Smirnov distance.
constexpr std::size_t kFineBins = 8192;
constexpr double kFinePerUnit = 1024;
// The histogram that is shown.
constexpr std::size_t kBins = 60;
constexpr double kBinWidth = 0.1;
constexpr std::size_t kMostMasses = 8;  // shown one by one
// Of c²/2, for H.
constexpr std::size_t kEnergyBins = 32;
constexpr double kEnergyWidth = 0.25;

/// H of a distribution over the energy bins. Bins without disks add nothing.
double h_of(const std::array<double, kEnergyBins>& shares) {
  const double area = 2 * kPi * kEnergyWidth;
  double sum = 0;
  for (const double share : shares) {
    if (share > 0) sum += share * std::log(share / area);
  }
  return sum;
}

/// Of Maxwell's distribution, seen through the same bins.
double h_of_maxwell() {
  std::array<double, kEnergyBins> shares{};
  for (std::size_t bin = 0; bin < kEnergyBins; ++bin) {
    const double low = kEnergyWidth * static_cast<double>(bin);
    const double beyond = bin + 1 < kEnergyBins ? std::exp(-(low + kEnergyWidth)) : 0;
    shares[bin] = std::exp(-low) - beyond;
  }
  return h_of(shares);
}

class Speeds final : public Observable {
 public:
  Speeds(const Subject& subject, double contacts, double interval)
      : from_frames_(subject.spacing.has_value()),
        contacts_(contacts),
        interval_(interval),
        disks_(static_cast<double>(subject.system.size())),
        freedom_(degrees_of_freedom(subject.system)),
        conserved_(subject.system.box.conserved_axes()),
        masses_(masses_of(subject.system)),
        fine_(kFineBins),
        shown_(kBins * (masses_.size() + 1)) {
    for (const Species& kind : subject.system.species) {
      const auto found = std::find(masses_.begin(), masses_.end(), kind.mass);
      group_of_.push_back(found != masses_.end() ? static_cast<std::size_t>(found - masses_.begin()) + 1 : 0);
    }
    disks_in_.assign(masses_.size() + 1, 0);
    disks_in_[0] = disks_;
    for (const std::uint32_t kind : subject.system.species_of) {
      if (group_of_[kind] > 0) ++disks_in_[group_of_[kind]];
    }
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "speeds"; }
  [[nodiscard]] double interval() const noexcept override { return from_frames_ ? 0 : interval_; }

  void on_window(const WindowRecord& window) override {
    const auto contacts = static_cast<double>(2 * (window.books.collisions - window.books_before.collisions) +
                                              (window.books.wall_collisions - window.books_before.wall_collisions));
    contacts_since_ += contacts / disks_;
    time_since_ += window.before.clock.length;
    look(window.system, window.after.disks, contacts_since_ >= contacts_, !(interval_ > 0));
  }

  void on_frame(const System& system, const Frame& frame) override {
    if (from_frames_) time_since_ += frames_ > 0 ? frame.time - last_frame_ : 0;
    last_frame_ = frame.time;
    ++frames_;
    look(system, frame, from_frames_, true);
  }

  [[nodiscard]] Measurement result() const override {
    Measurement measurement;
    measurement.name = name();
    add_estimates(measurement);
    measurement.tables = {histogram(), h_over_time()};
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    sums.number("interval", interval_);
    sums.number("contacts_since", contacts_since_);
    sums.number("time_since", time_since_);
    sums.number("sampled_time", sampled_time_);
    sums.number("frames", frames_);
    sums.number("last_frame", last_frame_);
    sums.numbers("fine", fine_);
    shown_.exchange(sums.below("shown"));
    moments_.exchange(sums.below("moments"));
    h_.exchange(sums.below("h"));
  }

 private:
  static std::vector<double> masses_of(const System& system) {
    std::vector<double> masses;
    for (const Species& kind : system.species) {
      if (std::find(masses.begin(), masses.end(), kind.mass) == masses.end()) masses.push_back(kind.mass);
      if (masses.size() > kMostMasses) return {};
    }
    return masses.size() == 1 ? std::vector<double>{} : masses;
  }

  /// Adds a frame to the histograms, and its H to the series.
  void look(const System& system, const Frame& frame, bool as_sample, bool as_h) {
    if (!as_sample && !as_h) return;
    const double kT = temperature(system, frame);
    if (!(kT > 0)) return;
    const Vec2 drift = drift_velocity(system, frame);
    std::array<std::int64_t, kEnergyBins> energies{};
    std::vector<double> counts(shown_.columns());
    double squares = 0;
    double fourths = 0;
    for (std::size_t k = 0; k < frame.size(); ++k) {
      const Vec2 v = frame.velocity(k) - drift;
      const double c2 = system.mass(k) * dot(v, v) / kT;
      const auto energy_bin = static_cast<std::size_t>(c2 * (0.5 / kEnergyWidth));
      ++energies[std::min(energy_bin, kEnergyBins - 1)];
      if (!as_sample) continue;
      squares += c2;
      fourths += c2 * c2;
      count(std::sqrt(c2), group_of_[system.species_of[k]], counts);
    }
    if (as_h) h_.add(frame.time, h_from(energies));
    if (!as_sample) return;
    keep(counts);
    moments_.add(disks_ * fourths / (squares * squares));
    sampled_time_ += time_since_;
    contacts_since_ = time_since_ = 0;
  }

  void count(double c, std::size_t group, std::vector<double>& counts) {
    ++fine_[std::min(static_cast<std::size_t>(c * kFinePerUnit), kFineBins - 1)];
    const auto bin = static_cast<std::size_t>(c * (1 / kBinWidth));
    if (bin >= kBins) return;
    ++counts[bin];
    if (group > 0) ++counts[group * kBins + bin];
  }

  /// Ends a sample whose histograms are `counts`.
  void keep(const std::vector<double>& counts) {
    for (std::size_t column = 0; column < counts.size(); ++column) {
      shown_.add(column, counts[column] / (kBinWidth * disks_in_[column / kBins]));
    }
    shown_.end_sample();
  }

  [[nodiscard]] double h_from(const std::array<std::int64_t, kEnergyBins>& energies) const {
    std::array<double, kEnergyBins> shares{};
    double used = 0;
    for (std::size_t bin = 0; bin < kEnergyBins; ++bin) {
      shares[bin] = static_cast<double>(energies[bin]) / disks_;
      used += energies[bin] > 0 ? 1 : 0;
    }
    return h_of(shares) - (used - 1) / (2 * disks_);
  }

  /// P(≤ c) of a disk among N of given energy.
  [[nodiscard]] double expected_share_below(double c) const {
    const double q = 1 - conserved_ / (2 * disks_);
    const double rest = 1 - c * c / (q * freedom_);
    return rest > 0 ? -std::expm1(0.5 * (freedom_ - 2) * std::log(rest)) : 1;
  }

  [[nodiscard]] KolmogorovTest kolmogorov_test() const {
    std::int64_t total = 0;
    for (const std::int64_t count : fine_) total += count;
    std::int64_t below = 0;
    double distance = 0;
    for (std::size_t bin = 0; bin + 1 < kFineBins; ++bin) {
      below += fine_[bin];
      const double share = static_cast<double>(below) / static_cast<double>(total);
      distance =
          std::max(distance, std::abs(share - expected_share_below(static_cast<double>(bin + 1) / kFinePerUnit)));
    }
    return {distance, p_value_of_exponential(distance, static_cast<double>(total))};
  }

  void add_estimates(Measurement& measurement) const {
    const std::uint64_t samples = moments_.result().samples;
    const double spacing = sampled_time_ / static_cast<double>(from_frames_ ? samples - 1 : samples);
    Estimate& ratio = add_estimate(measurement, "moment_ratio", "", moments_, spacing);
    if (masses_.empty() && conserved_ != 1) {
      ratio.theory = 2 * freedom_ / (freedom_ + 2);
      ratio.theory_source = "Maxwell, N disks of given energy";
    }
    if (samples == 0) return;
    const KolmogorovTest test = kolmogorov_test();
    add_estimate(measurement, "ks_distance", "", test.distance).samples = samples;
    Estimate& p_value = add_estimate(measurement, "ks_p_value", "", test.p_value);
    p_value.samples = samples;
    if (from_frames_) {
      p_value.warnings.emplace_back("holds if frames are further apart than velocities are correlated");
    }
    add_estimate(measurement, "sample_spacing", "time", spacing);
  }

  [[nodiscard]] Table histogram() const {
    Table table{.name = "speeds", .title = "Speeds", .columns = {}};
    Column speed{"speed", "speed v √(m/kT)", "", {}};
    Column theory{"f_theory", "Maxwell", "", {}};
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      const double low = static_cast<double>(bin) * kBinWidth;
      speed.values.push_back(low + 0.5 * kBinWidth);
      theory.values.push_back((std::exp(-0.5 * low * low) - std::exp(-0.5 * (low + kBinWidth) * (low + kBinWidth))) /
                              kBinWidth);
    }
    table.columns.push_back(speed);
    add_densities(table, 0, "f", "distribution of speeds");
    table.columns.push_back(theory);
    for (std::size_t group = 0; group < masses_.size(); ++group) {
      add_densities(table, group + 1, "f_" + std::to_string(group + 1),
                    "of the disks of mass " + shortest(masses_[group]));
    }
    table.bars = true;
    return table;
  }

  static std::string shortest(double value) {
    std::string text = std::to_string(value);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
  }

  /// Columns of the density of a group of disks, and its error.
  void add_densities(Table& table, std::size_t group, const std::string& name, const std::string& label) const {
    Column density{name, label, "", {}};
    Column error = error_column(density);
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      append(density, error, shown_.mean(group * kBins + bin));
    }
    table.columns.push_back(density);
    table.columns.push_back(error);
  }

  [[nodiscard]] Table h_over_time() const {
    Column time{"time", "time t", "time", h_.times()};
    Column h{"H", "Boltzmann's H", "", h_.values()};
    Column theory{"H_theory", "Maxwell", "", std::vector<double>(h_.times().size(), h_of_maxwell())};
    return {.name = "boltzmann_h", .title = "Boltzmann's H", .columns = {time, h, theory}};
  }

  const bool from_frames_;
  const double contacts_;
  double interval_;  // of frames for H; 0: at the ends of windows
  const double disks_;
  const double freedom_;
  const int conserved_;
  const std::vector<double> masses_;   // empty if there is one only, or too many
  std::vector<std::size_t> group_of_;  // by species: 1 + index into masses_, 0 if that is empty
  std::vector<double> disks_in_;       // all, then by mass

  double contacts_since_ = 0;  // the last sample, per disk
  double time_since_ = 0;
  double sampled_time_ = 0;  // from sample to sample
  std::uint64_t frames_ = 0;
  double last_frame_ = 0;
  std::vector<std::int64_t> fine_;
  Batches shown_;  // bins of all disks, then those of each mass
  Blocking moments_;
  TimeSeries h_;
};

}  // namespace

ObservableKind speeds_kind() {
  return {.name = "speeds",
          .summary = "speeds against Maxwell's distribution, and Boltzmann's H",
          .from_frames = true,
          .options = {{.name = "contacts",
                       .meaning = "contacts per disk between two samples of the distribution",
                       .standard = "8",
                       .whole = false,
                       .least = 0},
                      {.name = "interval",
                       .meaning = "time between two values of H",
                       .standard = "windows",
                       .whole = false,
                       .least = std::numeric_limits<double>::min()}},
          .make = [](const Subject& subject, const ObservableOptions& options) -> std::unique_ptr<Observable> {
            if (!(degrees_of_freedom(subject.system) > 2)) throw Error("speeds: there are too few disks");
            if (subject.spacing && options.find("interval")) frame_interval(options, subject, 1);  // says why not
            return std::make_unique<Speeds>(subject, options.number("contacts", kStandardContacts),
                                            options.number("interval", 0));
          }};
}

}  // namespace carom
