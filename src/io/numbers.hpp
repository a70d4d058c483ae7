// Numbers from text and back, exactly.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>

namespace carom::io {

/// A number read from text, or what is wrong with the text: "is not a number", "is too large for a number", …
struct ParsedNumber {
  double value = 0;
  std::string_view fault;  ///< empty if all is well
};

/// The double nearest to a decimal number. The whole text must be the number; NaN and infinity are faults, and so is
/// what is beyond the largest double.
ParsedNumber parse_number(std::string_view text) noexcept;

/// A whole number, 0 or more, without sign; nothing if the text is anything else or too large.
std::optional<std::uint64_t> parse_count(std::string_view text) noexcept;

/// Appends a number with 17 significant digits, which read back to the same bits.
template <typename Buffer>
void append_17_digits(Buffer& buffer, double value) {
  fmt::format_to(std::back_inserter(buffer), "{:.17g}", value);
}

}  // namespace carom::io
