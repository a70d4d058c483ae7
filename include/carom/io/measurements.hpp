// What observables found, in files and as text.
#pragma once

#include <string>
#include <vector>

#include "carom/run/measurement.hpp"

namespace carom {

/// A header row with the names of the columns, then the rows with 17 significant digits; "nan" where there is no value.
std::string table_csv(const Table& table);

/// Writes every table to `directory`/NAME.csv, and `directory`/index.json: an object with the key `observables`, a list
/// of {name, estimates, warnings, tables}; each table has name, file, title, logarithmic_x, logarithmic_y, bars and its
/// columns' name, label and unit. Creates the directory. Throws Error if anything cannot be written.
void write_measurements(const std::vector<Measurement>& measurements, const std::string& directory);

/// One JSON object: observable → list of estimates with their name, value, error, unit, samples, blocks,
/// correlation_time, theory, theory_source and warnings. Values that are absent or no number are null.
std::string measurements_json(const std::vector<Measurement>& measurements);

/// The same for people: "Observables", then a line per estimate with its error in brackets.
std::string measurements_text(const std::vector<Measurement>& measurements);

}  // namespace carom
