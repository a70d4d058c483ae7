#include "numbers.hpp"

#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>

namespace carom::io {

ParsedNumber parse_number(std::string_view text) noexcept {
  if (text.empty()) return {0, "is missing"};
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) return {0, "is not a number"};
  const bool spelled_out = text.find_first_of("0123456789") == std::string_view::npos;  // nan, inf
  if (spelled_out) return {0, "is not a finite number"};
  if (!std::isfinite(value)) return {0, "is too large for a number (over 1.8e308)"};
  return {value, {}};
}

std::optional<std::uint64_t> parse_count(std::string_view text) noexcept {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace carom::io
