#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "carom/carom/plots.hpp"
#include "carom/carom/scene_keys.hpp"
#include "carom/carom/sweep.hpp"
#include "carom/observe/theory.hpp"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kFluidEnds = 0.69;  // packing fraction up to which the fluid's equation of state was fitted

const SweepMean::Quantity* find(const SweepMean& mean, const std::string& name) {
  const auto found = std::find_if(mean.quantities.begin(), mean.quantities.end(),
                                  [&](const SweepMean::Quantity& quantity) { return quantity.name == name; });
  return found == mean.quantities.end() ? nullptr : &*found;
}

double value_of(const SweepMean& mean, const std::string& name) {
  const SweepMean::Quantity* const quantity = find(mean, name);
  return quantity == nullptr ? kNone : quantity->mean.value_or(kNone);
}

bool varies_packing(const std::string& key) {
  return key == "packing" || (key.starts_with("gas.") && key.ends_with("packing_fraction"));
}

/// Whether every job is an elastic gas of equal disks in a periodic box, which the equation of state is for.
bool all_are_plain_gases(const Scene& scene, const std::vector<VariedKey>& varied) {
  if (!scene.disks.empty() || scene.gas.empty() || scene.restitution != 1) return false;
  if (scene.boundary[0] != Boundary::periodic || scene.boundary[1] != Boundary::periodic) return false;
  const auto equal = [&](const GasSpec& gas) { return gas.radius == scene.gas.front().radius; };
  if (!std::all_of(scene.gas.begin(), scene.gas.end(), equal)) return false;
  return std::none_of(varied.begin(), varied.end(), [&](const VariedKey& one) {
    const std::string key = full_scene_key(one.key);
    const bool of_one_gas = scene.gas.size() > 1 && key.ends_with("radius");
    return of_one_gas || key == "radius_ratio" || key == "physics.restitution";
  });
}

/// "restitution = 0.9, mass_ratio = 2": the values of all keys but the first.
std::string label_of(const std::vector<VariedKey>& varied, const std::vector<double>& values) {
  std::string label;
  for (std::size_t k = 1; k < varied.size(); ++k) {
    label += fmt::format("{}{} = {}", k > 1 ? ", " : "", varied[k].key, values[k]);
  }
  return label;
}

/// One column of the means against the first key, or against the packing fraction that came of it.
class SweepPlots {
 public:
  SweepPlots(const SweepPlan& plan, std::vector<SweepMean> means)
      : varied_(plan.varied), means_(std::move(means)), plain_(all_are_plain_gases(plan.file.scene, plan.varied)) {}

  std::vector<NamedPlot> all() {
    if (means_.empty() || varied_.empty()) return {};
    std::vector<NamedPlot> plots;
    const bool packing = varies_packing(varied_.front().key);
    // The one that was observed has an error of its own, where each point was run once.
    const std::string z = everywhere("pressure.Z") ? "pressure.Z" : "Z";
    if (has(z)) {
      plots.push_back(plot_of(packing ? "equation_of_state" : "Z", z, "compressibility factor Z = \u03b2P/\u03c1"));
      plots.back().plot.title = packing ? "Equation of state" : "Compressibility factor";
      if (packing && plain_) add_equation_of_state(plots.back().plot);
    }
    for (const SweepMean::Quantity& quantity : means_.front().quantities) {
      const bool observed = quantity.name.find('.') != std::string::npos;
      if (observed && has(quantity.name)) plots.push_back(plot_with_theory(quantity));
    }
    return plots;
  }

 private:
  [[nodiscard]] bool has(const std::string& name) const {
    return std::any_of(means_.begin(), means_.end(),
                       [&](const SweepMean& mean) { return std::isfinite(value_of(mean, name)); });
  }

  [[nodiscard]] bool everywhere(const std::string& name) const {
    return std::all_of(means_.begin(), means_.end(),
                       [&](const SweepMean& mean) { return std::isfinite(value_of(mean, name)); });
  }

  [[nodiscard]] double abscissa(const SweepMean& mean) const {
    const bool packing = varies_packing(varied_.front().key);
    return packing ? value_of(mean, "packing_fraction") : mean.values.front();
  }

  [[nodiscard]] NamedPlot plot_of(const std::string& file, const std::string& column, const std::string& label) const {
    NamedPlot named{file_name_for(file), column, {}};
    const bool packing = varies_packing(varied_.front().key);
    named.plot.title = column;
    named.plot.x.label = packing ? "packing fraction \u03b7" : varied_.front().key;
    PlotPanel panel;
    panel.y.label = label;
    for (const SweepMean& mean : means_) add_point(mean, column, panel);
    named.plot.panels.push_back(std::move(panel));
    return named;
  }

  [[nodiscard]] NamedPlot plot_with_theory(const SweepMean::Quantity& quantity) const {
    std::string label = quantity.name.substr(quantity.name.find('.') + 1);
    std::replace(label.begin(), label.end(), '_', ' ');
    if (!quantity.unit.empty()) label += " (" + quantity.unit + ')';
    NamedPlot named = plot_of(quantity.name, quantity.name, label);
    if (varied_.size() > 1) return named;  // a curve for each point of the others would hide what was measured
    Series theory{Series::Style::theory, "theory", {}, {}, {}};
    for (const SweepMean& mean : means_) {
      const SweepMean::Quantity* const found = find(mean, quantity.name);
      if (found == nullptr || !found->theory) continue;
      theory.x.push_back(abscissa(mean));
      theory.y.push_back(*found->theory);
    }
    if (!theory.x.empty()) named.plot.panels.front().series.push_back(std::move(theory));
    return named;
  }

  void add_point(const SweepMean& mean, const std::string& column, PlotPanel& panel) const {
    const SweepMean::Quantity* const quantity = find(mean, column);
    if (quantity == nullptr) return;
    const std::string label = varied_.size() > 1 ? label_of(varied_, mean.values) : "measured, \u00b1 1 standard error";
    auto series =
        std::find_if(panel.series.begin(), panel.series.end(), [&](const Series& one) { return one.label == label; });
    if (series == panel.series.end()) {
      panel.series.push_back({Series::Style::measured, label, {}, {}, {}});
      series = panel.series.end() - 1;
    }
    series->x.push_back(abscissa(mean));
    series->y.push_back(quantity->mean.value_or(kNone));
    series->error.push_back(quantity->error.value_or(kNone));
  }

  void add_equation_of_state(Plot& plot) const {
    double low = 1, high = 0;
    for (const SweepMean& mean : means_) {
      const double eta = abscissa(mean);
      if (!std::isfinite(eta)) continue;
      low = std::min(low, eta);
      high = std::max(high, eta);
    }
    high = std::min(high, kFluidEnds);
    if (!(low <= high)) return;
    Series curve{Series::Style::theory, "Kolafa and Rottner 2006", {}, {}, {}};
    constexpr int kPoints = 200;
    for (int k = 0; k <= kPoints; ++k) {
      curve.x.push_back(low + (high - low) * k / kPoints);
      curve.y.push_back(kolafa_rottner(curve.x.back()));
    }
    plot.panels.front().series.push_back(std::move(curve));
  }

  std::vector<VariedKey> varied_;
  std::vector<SweepMean> means_;
  bool plain_;
};

}  // namespace

bool is_sweep(const std::string& directory) {
  std::error_code ignored;
  return fs::exists(fs::path(directory) / "sweep.json", ignored);
}

std::vector<NamedPlot> plots_of_sweep(const std::string& directory) {
  const SweepSettings settings = read_sweep_settings((fs::path(directory) / "sweep.json").string());
  SweepPlan plan;
  plan.file = parse_scene(settings.scene, "sweep.json.toml");
  plan.varied = settings.varied;
  plan.replicas = settings.replicas;
  std::vector<SweepRow> rows;
  for (const SweepJob& job : jobs_of_sweep(plan)) {
    const std::string job_directory = (fs::path(directory) / "runs" / job.name).string();
    if (std::optional<SweepRow> row = read_finished_job(job_directory, job)) rows.push_back(std::move(*row));
  }
  return SweepPlots(plan, means_of(rows)).all();
}

}  // namespace carom
