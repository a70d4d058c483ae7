#include "carom/base/error_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace carom {
namespace {

/// digits × 10^exponent.
struct Decimal {
  int digits = 0;
  int exponent = 0;
};

/// The exponent of "d.de±xx".
int exponent_in(std::string_view text) {
  const char* begin = text.data() + text.find('e') + 1;
  if (*begin == '+') ++begin;
  int exponent = 0;
  std::from_chars(begin, text.data() + text.size(), exponent);
  return exponent;
}

/// A positive number rounded to one or two digits.
Decimal rounded(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);  // "d.de±xx"
  Decimal decimal;
  for (const char c : std::string_view(text).substr(0, text.find('e'))) {
    if (c != '.') decimal.digits = 10 * decimal.digits + (c - '0');
  }
  decimal.exponent = exponent_in(text) - (digits - 1);
  return decimal;
}

Decimal rounded_error(double error) {
  const Decimal two = rounded(error, 2);
  if (two.digits < 30) return two;
  const Decimal one = rounded(error, 1);
  return one.digits == 1 ? Decimal{10, one.exponent - 1} : one;
}

/// Decimal exponent of a number's first digit when it is rounded at 10^last.
int leading_exponent(double value, int last) {
  if (value == 0) return last;
  const int before = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (before < last) return last;
  return exponent_in(fmt::format("{:.{}e}", value, before - last));
}

}  // namespace

std::string with_error(double value, std::optional<double> error) {
  constexpr int kMostDigitsBeforePoint = 6;
  constexpr int kMostZerosBehindPoint = 4;
  constexpr double kRounding = 1e-13;  // of a value: smaller errors are those of doubles
  const bool shows = error && *error > kRounding * std::abs(value) && std::isfinite(*error);
  if (!std::isfinite(value) || !shows) return fmt::format("{:.6g}", value);
  const Decimal shown = rounded_error(*error);
  const int leading = leading_exponent(value, shown.exponent);
  const int first = std::max(leading, shown.exponent + (shown.digits > 9 ? 1 : 0));
  const bool plain = shown.exponent <= 0 && first < kMostDigitsBeforePoint && first >= -kMostZerosBehindPoint;
  if (plain) return fmt::format("{:.{}f}({})", value, -shown.exponent, shown.digits);
  const int decimals = first - shown.exponent;
  const std::string text = fmt::format("{:.{}e}", value, decimals);
  // Where that has another exponent, the value is rounded to more or fewer digits than it has here.
  const bool fits = exponent_in(text) == first;
  const std::string digits =
      fits ? text.substr(0, text.find('e')) : fmt::format("{:.{}f}", value / std::pow(10.0, first), decimals);
  return fmt::format("{}({})e{}", digits, shown.digits, first);
}

}  // namespace carom
