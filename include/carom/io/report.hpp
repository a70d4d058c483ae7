// What a run says about itself at its end.
#pragma once

#include <string>
#include <vector>

#include "carom/run/measurement.hpp"
#include "carom/run/summary.hpp"

namespace carom {

/// A summary and what only the program that ran it knows.
struct RunRecord {
  Summary summary;
  double wall_seconds = 0;
  std::string scene_digest;  ///< digest(system, frame) at the start
  std::string version;
  std::string command;   ///< as typed
  std::string compiler;  ///< name and version
  std::vector<Measurement> observables = {};
};

/// One JSON object in a fixed order of keys; numbers read back to the same bits, what has no value is null.
std::string report_json(const RunRecord& record);

/// The same for people: a few aligned lines, then the certificate.
std::string report_text(const RunRecord& record);

}  // namespace carom
