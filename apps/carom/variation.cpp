#include "variation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "command.hpp"
#include "options.hpp"

namespace carom::program {
namespace {

constexpr double kMostValues = 1e6;
constexpr double kRounding = 1e-6;  // of a step: how far TO may lie from the last value

double rounded(double value) {
  const double near = std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr);
  return near == 0 ? 0 : near;
}

[[noreturn]] void refuse(const std::string& text, const std::string& reason) {
  throw UsageError(fmt::format("--vary {}: {}", text, reason));
}

std::vector<double> values_in_range(const std::string& text, double from, double to, double step) {
  if (step == 0) refuse(text, "the step is 0");
  const double steps = (to - from) / step;
  if (steps < 0) refuse(text, fmt::format("steps of {} do not lead from {} to {}", step, from, to));
  if (!(steps < kMostValues)) refuse(text, fmt::format("these are more than {:g} values", kMostValues));
  std::vector<double> values;
  for (double k = 0; k <= steps + kRounding; ++k) values.push_back(rounded(from + k * step));
  return values;
}

void refuse_repeated(const std::string& text, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto twice = std::adjacent_find(values.begin(), values.end());
  if (twice != values.end()) refuse(text, fmt::format("{} is there twice", *twice));
}

}  // namespace

VariedKey parse_variation(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    refuse(text, "give KEY=FROM:TO:STEP, for instance packing=0.60:0.72:0.01, or KEY=A,B,C");
  }
  VariedKey varied{text.substr(0, equals), {}};
  std::string range = text.substr(equals + 1);
  const auto colons = std::count(range.begin(), range.end(), ':');
  const bool commas = range.find(',') != std::string::npos;
  if (colons != 0 && (colons != 2 || commas)) refuse(text, "a range is FROM:TO:STEP, for instance 0.60:0.72:0.01");
  std::replace(range.begin(), range.end(), ':', ',');
  const std::vector<double> numbers = parse_numbers("--vary " + varied.key, range);
  varied.values = colons == 2 ? values_in_range(text, numbers[0], numbers[1], numbers[2]) : numbers;
  refuse_repeated(text, varied.values);
  return varied;
}

}  // namespace carom::program
