#include <algorithm>
#include <cmath>
#include <string_view>

#include "carom/draw/plot.hpp"

namespace carom {
namespace {

constexpr std::string_view kError = "_error";
constexpr std::string_view kTheory = "_theory";

const Column* column_named(const Table& table, const std::string& name) {
  const auto found = std::find_if(table.columns.begin() + 1, table.columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  return found == table.columns.end() ? nullptr : &*found;
}

// Whether the column only goes with another one: "g_error" with "g".
bool goes_with_another(const Table& table, const Column& column) {
  for (const std::string_view ending : {kError, kTheory}) {
    if (!column.name.ends_with(ending)) continue;
    const std::string other = column.name.substr(0, column.name.size() - ending.size());
    if (column_named(table, other) != nullptr) return true;
  }
  return false;
}

const std::string& label_of(const Column& column) { return column.label.empty() ? column.name : column.label; }

std::string with_unit(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : label + " (" + unit + ")";
}

// Tables made by hand may have columns of different lengths.
std::vector<double> first(const std::vector<double>& values, std::size_t rows) {
  return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(std::min(rows, values.size()))};
}

Series series_of(const Table& table, const Column& column) {
  Series series;
  series.style = table.bars ? Series::Style::bars : Series::Style::measured;
  series.label = label_of(column);
  const std::size_t rows = std::min(table.columns.front().values.size(), column.values.size());
  series.x = first(table.columns.front().values, rows);
  series.y = first(column.values, rows);
  const Column* error = column_named(table, column.name + std::string(kError));
  if (error != nullptr && error->values.size() >= rows) series.error = first(error->values, rows);
  return series;
}

Series theory_of(const Table& table, const Column& theory, const std::string& label) {
  Series series;
  series.style = Series::Style::theory;
  series.label = label;
  const std::size_t rows = std::min(table.columns.front().values.size(), theory.values.size());
  series.x = first(table.columns.front().values, rows);
  series.y = first(theory.values, rows);
  return series;
}

double largest_size(const Column& column) {
  double largest = 0;
  for (const double value : column.values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

bool has_companion(const Table& table, const Column& column) {
  return column_named(table, column.name + std::string(kError)) != nullptr ||
         column_named(table, column.name + std::string(kTheory)) != nullptr;
}

// Whether two columns are fit for one axis: the same unit, neither would look like a line at 0 beside the other, and
// not a measured one beside one that only says how it was measured, such as a count.
bool comparable(const Table& table, const Column& a, const Column& b) {
  constexpr double kMostUnlike = 4;
  if (has_companion(table, a) != has_companion(table, b)) return false;
  const double size_a = largest_size(a), size_b = largest_size(b);
  const bool alike = size_a == 0 || size_b == 0 || std::max(size_a, size_b) <= kMostUnlike * std::min(size_a, size_b);
  return a.unit == b.unit && alike;
}

// One panel of columns that are fit for one axis.
PlotPanel panel_of(const Table& table, const std::vector<const Column*>& columns) {
  PlotPanel panel;
  const bool alone = columns.size() == 1;
  const Column& only = *columns.front();
  panel.y = {alone ? with_unit(label_of(only), only.unit) : only.unit, table.logarithmic_y};
  for (const Column* column : columns) {
    panel.series.push_back(series_of(table, *column));
    if (alone)
      panel.series.back().label = panel.series.back().error.empty() ? "measured" : "measured, \u00b1 1 standard error";
    const Column* theory = column_named(table, column->name + std::string(kTheory));
    if (theory == nullptr) continue;
    const std::string label = alone ? "theory" : label_of(*column) + ", theory";
    panel.series.push_back(theory_of(table, *theory, label));
  }
  return panel;
}

}  // namespace

Plot plot_of_table(const Table& table) {
  Plot plot;
  plot.title = table.title.empty() ? table.name : table.title;
  plot.x.logarithmic = table.logarithmic_x;
  std::vector<std::vector<const Column*>> groups;
  if (!table.columns.empty()) {
    const Column& abscissa = table.columns.front();
    plot.x.label = with_unit(label_of(abscissa), abscissa.unit);
    for (std::size_t k = 1; k < table.columns.size(); ++k) {
      const Column& column = table.columns[k];
      if (goes_with_another(table, column)) continue;
      const auto group = std::find_if(groups.begin(), groups.end(), [&](const std::vector<const Column*>& some) {
        return comparable(table, *some.front(), column);
      });
      if (group == groups.end()) {
        groups.push_back({&column});
      } else {
        group->push_back(&column);
      }
    }
  }
  for (const std::vector<const Column*>& group : groups) plot.panels.push_back(panel_of(table, group));
  if (plot.panels.empty()) plot.panels.emplace_back();
  return plot;
}

}  // namespace carom
