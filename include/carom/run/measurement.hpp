// What observables find, as plain data: `observe` makes it, `io` writes it, `draw` draws it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carom {

/// A number with its error bar.
struct Estimate {
  std::string name;                  ///< "pressure", "collision_rate", … unique within its measurement
  std::string unit = {};             ///< "1/length²"; empty for pure numbers
  double value = 0;                  ///< NaN if the run was too short for one
  std::optional<double> error = {};  ///< one standard error; absent where it cannot be told
  std::uint64_t samples = 0;
  std::uint64_t blocks = 0;                     ///< at the level where blocking found its plateau; 0 if it found none
  std::optional<double> correlation_time = {};  ///< of the samples (time)
  std::optional<double> theory = {};            ///< what it should be, where that is known
  std::string theory_source = {};               ///< "Kolafa and Rottner 2006"
  std::vector<std::string> warnings = {};       ///< "the run is too short to tell the error …"
};

/// A column of a table, one entry per row.
struct Column {
  std::string name;   ///< "g"; its standard error stands in the column "g_error", what theory says in "g_theory"
  std::string label;  ///< for an axis, "pair distribution g(r)"
  std::string unit;
  std::vector<double> values = {};
};

/// A function that was measured: the first column is what it depends on.
struct Table {
  std::string name;   ///< "rdf"; a file of its own, observables/NAME.csv
  std::string title;  ///< for a picture
  std::vector<Column> columns = {};
  bool logarithmic_x = false;  ///< how it is best drawn
  bool logarithmic_y = false;
  bool bars = false;  ///< a histogram rather than a curve
};

/// All that one observable found.
struct Measurement {
  std::string name;  ///< of the observable
  std::vector<Estimate> estimates = {};
  std::vector<Table> tables = {};
  std::vector<std::string> warnings = {};  ///< "the run is too short to tell the error of …"
};

}  // namespace carom
