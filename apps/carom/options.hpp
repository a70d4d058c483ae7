// Options with values: numbers are read to the nearest double on every machine; what cannot be used is refused with the
// option's name, the value and the reason, as a UsageError.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/run/parallel.hpp"
#include "carom/run/settings.hpp"
#include "carom/window/solver.hpp"

namespace carom::program {

/// Throws the UsageError for a name that is none of `names`.
[[noreturn]] void refuse_choice(const std::string& option, const std::string& text,
                                const std::vector<std::string>& names);

template <typename Value>
std::vector<std::string> names_of(const std::map<std::string, Value>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  return names;
}

/// "A,B,C" as numbers. Throws UsageError naming `option` if one is not a finite number.
std::vector<double> parse_numbers(std::string_view option, const std::string& text);

/// An option whose value must be a finite number. `name` is its long name, with the dashes.
CLI::Option* add_number(CLI::App& command, const std::string& name, double& target, const std::string& description);
CLI::Option* add_number(CLI::App& command, const std::string& name, std::optional<double>& target,
                        const std::string& description);

/// An option whose value must be a whole number from 0 to 2⁶⁴ − 1; 1e6 will do.
CLI::Option* add_count(CLI::App& command, const std::string& name, std::uint64_t& target,
                       const std::string& description);
CLI::Option* add_count(CLI::App& command, const std::string& name, std::optional<std::uint64_t>& target,
                       const std::string& description);

/// An option whose value is the name of a file or a directory: `type` says which in the help.
CLI::Option* add_path(CLI::App& command, const std::string& name, std::string& target, const std::string& type,
                      const std::string& description);

/// The option --solver.
CLI::Option* add_solver(CLI::App& command, SolverKind& target);
/// An option whose value is a list of observables, "NAME,NAME". Throws UsageError for a name that there is not.
CLI::Option* add_observables(CLI::App& command, const std::string& name, std::vector<ObserveSpec>& target,
                             const std::string& description);
/// --threads and --patches.
void add_parallel(CLI::App& command, ParallelOptions& target);

/// An option whose value must be one of some names.
template <typename Value>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Value& target,
                        const std::map<std::string, Value>& values, const std::string& description) {
  return command
      .add_option_function<std::string>(
          name,
          [&target, name, values](const std::string& text) {
            const auto found = values.find(text);
            if (found == values.end()) refuse_choice(name, text, names_of(values));
            target = found->second;
          },
          description)
      ->type_name("NAME");
}

}  // namespace carom::program
