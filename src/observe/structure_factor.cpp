// The structure factor S(k) = ⟨|Σ exp(i k·r)|²⟩/N on the wave vectors that fit into the periodic box, averaged over
// shells of |k|; and its limit at small k, which the compressibility theorem gives: S(0) = kT ρ κ_T = 1/(d(ηZ)/dη).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "carom/base/error.hpp"
#include "carom/observe/batches.hpp"
#include "carom/observe/blocking.hpp"
#include "carom/observe/theory.hpp"
#include "columns.hpp"
#include "estimates.hpp"
#include "kinds.hpp"
#include "wave_vectors.hpp"

namespace carom {
namespace {

constexpr double kMeanFreeTimes = 32;
constexpr double kStandardRange = 15;    // k times the largest diameter
constexpr double kStandardWaves = 4000;  // along the longer side, at most
constexpr double kMostWaves = 1e5;
constexpr std::size_t kStandardShells = 100;
constexpr double kStandardCost = 2e7;  // disks times vectors
constexpr double kFewestVectors = 1000;
constexpr double kLimitRange = 2;  // k times the diameter up to which S(k) is fitted for its limit

/// 1/(d(ηZ)/dη).
double compressibility(double packing_fraction) {
  const double step = 1e-4 * packing_fraction;
  const auto pressure = [](double eta) { return eta * kolafa_rottner(eta); };
  return 2 * step / (pressure(packing_fraction + step) - pressure(packing_fraction - step));
}

class StructureFactor final : public Observable {
 public:
  StructureFactor(const System& system, WaveVectors waves, double interval)
      : interval_(interval),
        waves_(std::move(waves)),
        weights_(weights_of_limit(waves_.shells(), kLimitRange / (2 * system.largest_radius()))),
        fluid_(fluid_of_equal_disks(system)),
        by_shell_(waves_.shells().size()) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "structure_factor"; }
  [[nodiscard]] double interval() const noexcept override { return interval_; }

  void on_frame(const System& /*system*/, const Frame& frame) override {
    const std::vector<std::complex<double>> density = waves_.density_waves(frame);
    const auto disks = static_cast<double>(frame.size());
    double limit = 0;
    for (std::size_t s = 0; s < waves_.shells().size(); ++s) {
      const WaveShell& shell = waves_.shells()[s];
      double sum = 0;
      for (std::size_t k = shell.first; k < shell.last; ++k) sum += std::norm(density[k]) / disks;
      const double mean = sum / static_cast<double>(shell.last - shell.first);
      by_shell_.add(s, mean);
      if (s < weights_.size()) limit += weights_[s] * mean;
    }
    by_shell_.end_sample();
    if (!weights_.empty()) limit_.add(limit);
  }

  [[nodiscard]] Measurement result() const override {
    Measurement measurement;
    measurement.name = name();
    if (!weights_.empty()) {
      Estimate& limit = add_estimate(measurement, "S_0", "", limit_, interval_);
      if (fluid_) {
        limit.theory = compressibility(fluid_->packing_fraction);
        limit.theory_source = "compressibility of Kolafa and Rottner 2006, infinite system";
      }
    }
    Table table{
        .name = "structure_factor", .title = "Structure factor", .columns = {{"k", "wave number k", "1/length", {}}}};
    for (const WaveShell& shell : waves_.shells()) table.columns[0].values.push_back(shell.mean_k);
    append_columns(table, {"S", "structure factor S(k)", "", {}}, means_of(by_shell_));
    table.columns.push_back({"vectors", "wave vectors in the shell", "", {}});
    for (const WaveShell& shell : waves_.shells()) {
      table.columns.back().values.push_back(static_cast<double>(shell.last - shell.first));
    }
    measurement.tables.push_back(std::move(table));
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    sums.number("interval", interval_);
    by_shell_.exchange(sums.below("shells"));
    limit_.exchange(sums.below("limit"));
  }

 private:
  double interval_;
  WaveVectors waves_;
  std::vector<double> weights_;  // of shells in the limit at small k
  std::optional<EqualDisks> fluid_;

  Batches by_shell_;
  Blocking limit_;
};

std::unique_ptr<Observable> make(const Subject& subject, const ObservableOptions& options) {
  const Box& box = subject.system.box;
  if (!box.periodic(0) || !box.periodic(1)) {
    throw Error("structure_factor: the box must be periodic along both axes: only then waves fit into it");
  }
  const double one_wave = 2 * kPi / std::max(box.size.x, box.size.y);
  const double standard_k = std::min(kStandardRange / (2 * subject.system.largest_radius()), kStandardWaves * one_wave);
  const double k_max = options.number("k_max", standard_k);
  if (k_max > kMostWaves * one_wave) {
    throw Error(fmt::format("structure_factor: k_max of {} is more than {} waves along the box", k_max, kMostWaves));
  }
  const double affordable = kStandardCost / static_cast<double>(subject.system.size());
  const auto standard = static_cast<std::size_t>(std::max(affordable, kFewestVectors));
  WaveVectors waves(box.size, k_max, options.count("bins", kStandardShells), options.count("vectors", standard));
  if (waves.vectors().empty()) throw Error("structure_factor: k_max is smaller than 2π over the box: no wave fits");
  return std::make_unique<StructureFactor>(subject.system, std::move(waves),
                                           frame_interval(options, subject, kMeanFreeTimes));
}

}  // namespace

ObservableKind structure_factor_kind() {
  return {.name = "structure_factor",
          .summary = "structure factor S(k) and its limit at small k",
          .from_frames = true,
          .options = {interval_option("32 mean free times"),
                      {.name = "k_max",
                       .meaning = "largest wave number",
                       .standard = "15 over the largest diameter, at most 4000 waves along the box"},
                      {.name = "bins",
                       .meaning = "number of shells of k, at most",
                       .standard = "100",
                       .whole = true,
                       .least = 1,
                       .most = 1e5},
                      {.name = "vectors",
                       .meaning = "number of wave vectors, at most",
                       .standard = "2e7 over the number of disks, at least 1000",
                       .whole = true,
                       .least = 1,
                       .most = 1e7}},
          .make = make};
}

}  // namespace carom
