// What a run says about itself at its end.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "carom/run/measurement.hpp"
#include "carom/run/summary.hpp"

namespace carom {

/// Why a run ended.
enum class Ended {
  time,         ///< it reached the time asked for
  collisions,   ///< or the number of collisions
  exhausted,    ///< no two disks meet any more
  interrupted,  ///< by a signal
  out_of_time,  ///< by the clock
  untrusted     ///< its certificate does not hold
};

std::string_view name_of(Ended ended) noexcept;

/// A summary and what only the program that ran it knows.
struct RunRecord {
  Summary summary;
  double wall_seconds = 0;
  Ended ended = Ended::time;
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
