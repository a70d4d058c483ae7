#include "carom/io/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "carom/io/measurements.hpp"
#include "measurement_json.hpp"

namespace carom {
namespace {

std::optional<double> collisions_per_second(const RunRecord& record) {
  if (!(record.wall_seconds > 0)) return std::nullopt;
  return static_cast<double>(record.summary.collisions) / record.wall_seconds;
}

/// JSON has no NaN and no infinity: they are null, as is what is absent.
nlohmann::ordered_json number_or_null(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

/// Lines of a label and a value, the values under one another.
class Lines {
 public:
  void heading(std::string_view text) { fmt::format_to(end_, "{}\n", text); }

  template <typename... Arguments>
  void line(std::string_view label, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(end_, "  {:<18}", label);
    fmt::format_to(end_, format, std::forward<Arguments>(arguments)...);
    fmt::format_to(end_, "\n");
  }

  void number(std::string_view label, const std::optional<double>& value, std::string_view unit = {}) {
    if (value) line(label, "{:.6g}{}", *value, unit);
  }

  void add(std::string_view text) { text_.append(text); }

  [[nodiscard]] std::string text() const { return fmt::to_string(text_); }

 private:
  fmt::memory_buffer text_;
  std::back_insert_iterator<fmt::memory_buffer> end_ = std::back_inserter(text_);
};

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void describe_run(const RunRecord& record, Lines& lines) {
  const Summary& summary = record.summary;
  lines.heading("Run");
  lines.line("disks", "{}", summary.disks);
  lines.number("packing fraction", summary.packing_fraction);
  lines.number("simulated time", summary.time);
  lines.line("disk collisions", "{}", summary.collisions);
  lines.line("wall collisions", "{}", summary.wall_collisions);
  lines.number("temperature kT", summary.temperature);
  lines.number("pressure P/kT", summary.pressure, " per area");
  lines.line("took", "{:.3g} s", record.wall_seconds);
  lines.number("speed", collisions_per_second(record), " collisions per second");
  lines.line("solver", "{}, {}, {}, {}", summary.solver, summary.simd, counted(summary.threads, "thread", "threads"),
             counted(summary.patches, "patch", "patches"));
  if (summary.patches > 1) lines.line("duplicated work", "{:.3g} %", 100 * summary.duplicated_work);
}

void certify(const RunRecord& record, Lines& lines) {
  const Summary& summary = record.summary;
  lines.heading("Certificate");
  lines.line("windows", "{}, {} repaired", summary.windows, summary.windows_repaired);
  lines.line("ties", "{}{}", summary.ties,
             summary.ties > 0 ? " (contacts at one time: their outcome has no unique order)" : "");
  if (!summary.elastic) lines.line("collapses", "{} (contacts made elastic)", summary.collapses);
  lines.line("largest overlap", "{:.3g} contact distances", summary.max_overlap);
  lines.line(summary.elastic ? "energy drift" : "energy change", "{:.3g} of the energy at the start{}",
             summary.energy_drift, summary.elastic ? "" : " (restitution below 1)");
  if (summary.momentum_drift) lines.line("momentum drift", "{:.3g} of the sum of m|v|", *summary.momentum_drift);
  lines.line("digest", "{}", summary.digest);
  lines.line("scene digest", "{}", record.scene_digest);
  lines.line("carom", "{}, {}", record.version, record.compiler);
  for (const std::string& violation : violations(summary)) lines.line("NOT TO BE TRUSTED", " {}", violation);
}

}  // namespace

std::string report_json(const RunRecord& record) {
  const Summary& summary = record.summary;
  nlohmann::ordered_json report{
      {"disks", summary.disks},
      {"packing_fraction", number_or_null(summary.packing_fraction)},
      {"time", number_or_null(summary.time)},
      {"collisions", summary.collisions},
      {"wall_collisions", summary.wall_collisions},
      {"wall_seconds", number_or_null(record.wall_seconds)},
      {"collisions_per_second", number_or_null(collisions_per_second(record))},
      {"threads", summary.threads},
      {"patches", summary.patches},
      {"solver", summary.solver},
      {"simd", summary.simd},
      {"windows", summary.windows},
      {"windows_repaired", summary.windows_repaired},
      {"ties", summary.ties},
      {"collapses", summary.collapses},
      {"max_overlap", number_or_null(summary.max_overlap)},
      {"energy_drift", number_or_null(summary.energy_drift)},
      {"momentum_drift", number_or_null(summary.momentum_drift)},
      {"temperature", number_or_null(summary.temperature)},
      {"pressure", number_or_null(summary.pressure)},
      {"digest", summary.digest},
      {"scene_digest", record.scene_digest},
      {"version", record.version},
      {"command", record.command},
      {"compiler", record.compiler},
      {"patches_repaired", summary.patches_repaired},
      {"duplicated_work", number_or_null(summary.duplicated_work)},
      {"phase_seconds",
       {{"sort", summary.phases.sort},
        {"advance", summary.phases.advance},
        {"verify", summary.phases.verify},
        {"collect", summary.phases.collect}}},
  };
  report["observables"] = io::estimates_as_json(record.observables);
  return report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string report_text(const RunRecord& record) {
  Lines lines;
  describe_run(record, lines);
  if (!record.observables.empty()) lines.add(measurements_text(record.observables));
  certify(record, lines);
  return lines.text();
}

}  // namespace carom
