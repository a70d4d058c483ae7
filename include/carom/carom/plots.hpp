// Everything that can be plotted of a run or of a sweep. Only where carom is built with pictures.
#pragma once

#include <string>
#include <vector>

#include "carom/draw/plot.hpp"
#include "carom/io/sweep_files.hpp"

namespace carom {

/// A plot, and the name of its file without the ending: letters, digits, '_', '-' and '.' only.
struct NamedPlot {
  std::string name;
  std::string observable;  ///< what it shows: the name of a measurement, or of a column of sweep_mean.csv
  Plot plot;
};

/// What the run in a directory observed: a plot for each table. Throws Error if a file is not what carom writes.
std::vector<NamedPlot> plots_of_run(const std::string& directory);

/// Whether the directory holds a sweep rather than a run.
bool is_sweep(const std::string& directory);

/// What the finished jobs of a sweep found, against the first key varied, a curve for each value of the others; the
/// equation of state, Z against η, where that key is the packing fraction, beside that of Kolafa and Rottner. Throws
/// Error if a file is not what carom writes.
std::vector<NamedPlot> plots_of_sweep(const std::string& directory);

/// A few words as the name of a file: whatever is no letter, digit, '_', '-' or '.' becomes '_'.
std::string file_name_for(const std::string& words);

}  // namespace carom
