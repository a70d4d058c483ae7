#include "carom/observe/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "carom/base/error.hpp"
#include "carom/base/nearest_word.hpp"
#include "carom/run/window_length.hpp"
#include "kinds.hpp"

namespace carom {
namespace {

const ObservableKind* find_kind(std::string_view name) {
  for (const ObservableKind& kind : observable_kinds()) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

std::string meant(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string_view nearest = nearest_word(word, known);
  if (!nearest.empty()) return fmt::format("did you mean '{}'?", nearest);
  return known.empty() ? "there is none" : fmt::format("the known ones are {}", fmt::join(known, ", "));
}

std::string unknown_name(std::string_view name) {
  std::vector<std::string_view> known;
  for (const ObservableKind& kind : observable_kinds()) known.push_back(kind.name);
  return fmt::format("unknown observable '{}': {}", name, meant(name, known));
}

/// What is wrong with one option; empty if nothing.
std::string fault_of(const ObservableKind& kind, const std::string& option, double value) {
  std::vector<std::string_view> known;
  for (const OptionKind& candidate : kind.options) {
    known.push_back(candidate.name);
    if (candidate.name != option) continue;
    const bool fits = value >= candidate.least && value <= candidate.most;
    if (fits && (!candidate.whole || value == std::rint(value))) return {};
    const std::string_view what = candidate.whole ? "a whole number" : "a number";
    return candidate.most < std::numeric_limits<double>::max()
               ? fmt::format("{} of {} is {}: it must be {} from {} to {}", option, kind.name, value, what,
                             candidate.least, candidate.most)
               : fmt::format("{} of {} is {}: it must be {}, {} or more", option, kind.name, value, what,
                             candidate.least);
  }
  return fmt::format("unknown option '{}' of {}: {}", option, kind.name, meant(option, known));
}

void note_problems(const ObserveSpec& spec, std::vector<Problem>& problems) {
  const ObservableKind* kind = find_kind(spec.name);
  if (kind == nullptr) {
    problems.push_back({unknown_name(spec.name), spec.place});
    return;
  }
  for (const auto& [option, value] : spec.options) {
    const std::string fault = fault_of(*kind, option, value);
    if (fault.empty()) continue;
    const auto place = spec.places.find(option);
    problems.push_back({fault, place != spec.places.end() ? place->second : spec.place});
  }
}

/// The largest power of two that is not above `value`.
double power_of_two_below(double value) { return std::ldexp(1.0, std::ilogb(value)); }

}  // namespace

std::optional<double> ObservableOptions::find(std::string_view option) const {
  const auto found = spec_->options.find(std::string(option));
  return found != spec_->options.end() ? std::optional(found->second) : std::nullopt;
}

double ObservableOptions::number(std::string_view option, double standard) const {
  return find(option).value_or(standard);
}

std::size_t ObservableOptions::count(std::string_view option, std::size_t standard) const {
  const std::optional<double> found = find(option);
  return found ? static_cast<std::size_t>(*found) : standard;
}

const std::vector<ObservableKind>& observable_kinds() {
  static const std::vector<ObservableKind> kinds{
      msd_kind(),  pressure_kind(),      pressure_tensor_kind(),  psi6_kind(),        rate_kind(),
      rdf_kind(),  speeds_kind(),        structure_factor_kind(), temperature_kind(), temperature_profile_kind(),
      vacf_kind(), wall_pressure_kind(),
  };
  return kinds;
}

std::vector<Problem> problems_of(const std::vector<ObserveSpec>& specs) {
  std::vector<Problem> problems;
  std::set<std::string> seen;
  for (const ObserveSpec& spec : specs) {
    note_problems(spec, problems);
    if (!seen.insert(spec.name).second) {
      problems.push_back({fmt::format("the observable '{}' is asked for twice", spec.name), spec.place});
    }
  }
  return problems;
}

std::unique_ptr<Observable> make_observable(const ObserveSpec& spec, const Subject& subject) {
  const std::vector<Problem> problems = problems_of(std::vector{spec});
  if (!problems.empty()) throw Error(problems);
  const ObservableKind& kind = *find_kind(spec.name);
  if (subject.spacing && !kind.from_frames) {
    throw Error(fmt::format("{} needs every collision of a run; it cannot be had from frames", kind.name), spec.place);
  }
  return kind.make(subject, ObservableOptions(spec));
}

OptionKind interval_option(std::string_view standard) {
  return {.name = "interval",
          .meaning = "time between two frames",
          .standard = standard,
          .whole = false,
          .least = std::numeric_limits<double>::min()};
}

double frame_interval(const ObservableOptions& options, const Subject& subject, double mean_free_times) {
  const std::optional<double> interval = options.find("interval");
  if (interval && subject.spacing) {
    throw Error("interval is for runs: the frames of a saved trajectory are where they are");
  }
  if (interval) return *interval;
  if (subject.spacing) return *subject.spacing;
  State state;
  state.disks = subject.start;
  state.clock.length = 1;
  const double rate = expected_contacts(subject.system, state);
  const double wanted = mean_free_times / rate;
  return std::isfinite(wanted) && wanted > 0 ? power_of_two_below(wanted) : 1;
}

}  // namespace carom
