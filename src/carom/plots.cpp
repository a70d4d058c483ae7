#include "carom/carom/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "carom/base/error.hpp"

namespace carom {
namespace {

/// Two tables may have the same name: the second is called NAME-2.
void make_names_unique(std::vector<NamedPlot>& plots) {
  std::set<std::string> taken;
  for (NamedPlot& plot : plots) {
    const std::string name = plot.name;
    for (int number = 2; !taken.insert(plot.name).second; ++number) plot.name = fmt::format("{}-{}", name, number);
  }
}

}  // namespace

std::string file_name_for(const std::string& words) {
  constexpr std::size_t kLongest = 100;
  std::string name = words.substr(0, kLongest);
  for (char& letter : name) {
    const bool kept = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                      (letter >= '0' && letter <= '9') || letter == '_' || letter == '-' || letter == '.';
    if (!kept) letter = '_';
  }
  if (name.empty() || name.front() == '.' || name.front() == '-') name.insert(0, 1, '_');
  return name;
}

std::vector<NamedPlot> plots_of_run(const std::string& directory) {
  std::vector<NamedPlot> plots;
  for (const Measurement& measurement : read_measurements(directory)) {
    for (const Table& table : measurement.tables) {
      plots.push_back({file_name_for(table.name), measurement.name, plot_of_table(table)});
    }
  }
  make_names_unique(plots);
  return plots;
}

}  // namespace carom
