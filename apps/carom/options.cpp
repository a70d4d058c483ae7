#include "options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "carom/observe/registry.hpp"
#include "command.hpp"

namespace carom::program {
namespace {

constexpr std::uint64_t kMostThreads = 1024;
constexpr std::uint64_t kMostPatches = 4096;  // along one axis

/// The whole text as a finite number, or nothing. CLI11's own conversion goes through long double and rounds twice.
std::optional<double> number_in(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Digits, or a number like 1e6 that is whole and, below 2⁵³, means just one.
std::optional<std::uint64_t> count_in(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
  const std::optional<double> number = number_in(text);
  const bool whole = number && *number >= 0 && *number < 0x1p53 && *number == std::rint(*number);
  return whole ? std::optional(static_cast<std::uint64_t>(*number)) : std::nullopt;
}

/// The numbers of "4x4"; none if one of them is not a whole number.
std::vector<std::uint64_t> counts_across(const std::string& text) {
  std::vector<std::uint64_t> counts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('x', begin), text.size());
    const std::optional<std::uint64_t> count = count_in(std::string_view(text).substr(begin, end - begin));
    if (!count) return {};
    counts.push_back(*count);
    begin = end + 1;
  }
  return counts;
}

double parse_number(std::string_view option, const std::string& text) {
  const std::optional<double> value = number_in(text);
  if (!value) throw UsageError(fmt::format("{}: '{}' is not a finite number", option, text));
  return *value;
}

std::uint64_t parse_count(std::string_view option, const std::string& text) {
  const std::optional<std::uint64_t> value = count_in(text);
  if (!value) throw UsageError(fmt::format("{}: '{}' is not a whole number, 0 or more", option, text));
  return *value;
}

template <typename Target, typename Parse>
CLI::Option* add(CLI::App& command, const std::string& name, Target& target, const std::string& description,
                 const char* type, Parse parse) {
  return command
      .add_option_function<std::string>(
          name, [&target, name, parse](const std::string& text) { target = parse(name, text); }, description)
      ->type_name(type);
}

}  // namespace

void refuse_choice(const std::string& option, const std::string& text, const std::vector<std::string>& names) {
  throw UsageError(fmt::format("{}: '{}' is not one of {}", option, text, fmt::join(names, ", ")));
}

std::vector<double> parse_numbers(std::string_view option, const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::optional<double> value = number_in(CLI::detail::trim_copy(word));
    if (!value) throw UsageError(fmt::format("{} {}: '{}' is not a finite number", option, text, word));
    numbers.push_back(*value);
    begin = end + 1;
  }
  return numbers;
}

CLI::Option* add_number(CLI::App& command, const std::string& name, double& target, const std::string& description) {
  return add(command, name, target, description, "NUMBER", parse_number);
}

CLI::Option* add_number(CLI::App& command, const std::string& name, std::optional<double>& target,
                        const std::string& description) {
  return add(command, name, target, description, "NUMBER", parse_number);
}

CLI::Option* add_count(CLI::App& command, const std::string& name, std::uint64_t& target,
                       const std::string& description) {
  return add(command, name, target, description, "COUNT", parse_count);
}

CLI::Option* add_count(CLI::App& command, const std::string& name, std::optional<std::uint64_t>& target,
                       const std::string& description) {
  return add(command, name, target, description, "COUNT", parse_count);
}

CLI::Option* add_path(CLI::App& command, const std::string& name, std::string& target, const std::string& type,
                      const std::string& description) {
  const auto parse = [type](const std::string& option, const std::string& text) {
    if (text.empty()) throw UsageError(fmt::format("{}: the name is empty", option));
    return text;
  };
  return add(command, name, target, description, type.c_str(), parse);
}

CLI::Option* add_solver(CLI::App& command, SolverKind& target) {
  static const std::map<std::string, SolverKind> solvers{{"fast", SolverKind::fast},
                                                         {"reference", SolverKind::reference}};
  return add_choice(command, "--solver", target, solvers, "which solver: fast or reference; both give the same bits");
}

CLI::Option* add_observables(CLI::App& command, const std::string& name, std::vector<ObserveSpec>& target,
                             const std::string& description) {
  const auto parse = [](const std::string& option, const std::string& text) {
    std::vector<ObserveSpec> specs;
    for (const std::string& word : CLI::detail::split(text, ',')) {
      specs.push_back({.name = CLI::detail::trim_copy(word)});
    }
    const std::vector<Problem> problems = problems_of(specs);
    if (!problems.empty()) throw UsageError(fmt::format("{} {}: {}", option, text, problems.front().message));
    return specs;
  };
  return add(command, name, target, description, "NAME,...", parse);
}

void add_parallel(CLI::App& command, ParallelOptions& target) {
  const auto threads = [](const std::string& option, const std::string& text) {
    const std::uint64_t count = parse_count(option, text);
    if (count < 1 || count > kMostThreads) {
      throw Error(fmt::format("{} {}: it must be from 1 to {}", option, text, kMostThreads));
    }
    return static_cast<unsigned>(count);
  };
  add(command, "--threads", target.threads, "divide the work among so many threads; any number gives the same bits",
      "COUNT", threads);
  const auto patches = [](const std::string& option, const std::string& text) {
    const std::vector<std::uint64_t> counts = counts_across(text);
    if (counts.size() != 2) throw UsageError(fmt::format("{}: '{}' is not two whole numbers like 4x4", option, text));
    for (const std::uint64_t count : counts) {
      if (count < 1 || count > kMostPatches) {
        throw Error(fmt::format("{} {}: each number must be from 1 to {}", option, text, kMostPatches));
      }
    }
    return std::array{static_cast<std::uint32_t>(counts[0]), static_cast<std::uint32_t>(counts[1])};
  };
  add(command, "--patches", target.patches,
      "cut the plane into columns x rows of patches; chosen from system and threads by default", "AxB", patches);
}

}  // namespace carom::program
