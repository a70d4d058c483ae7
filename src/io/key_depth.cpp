#include "key_depth.hpp"

#include <algorithm>

namespace carom::io {
namespace {

constexpr std::size_t kNowhere = std::string_view::npos;

constexpr std::size_t kMostQuotes = 5;  // in a row at the end of a text of many lines: two may be of the text

bool is_quote(char letter) noexcept { return letter == '"' || letter == '\''; }

/// Where the quoted text that begins at `at` is over; nowhere if it is not closed.
std::size_t end_of_quoted(std::string_view text, std::size_t at) noexcept {
  const char quote = text[at];
  const auto quotes_at = [&](std::size_t place) {
    const std::string_view next = text.substr(place, kMostQuotes);
    return std::min(next.find_first_not_of(quote), next.size());
  };
  const bool many_lines = quotes_at(at) >= 3;
  for (at += many_lines ? 3 : 1; at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (text[at] == quote && !many_lines) {
      return at + 1;
    } else if (text[at] == quote && quotes_at(at) >= 3) {
      return at + quotes_at(at);
    } else if (text[at] == '\n' && !many_lines) {
      return kNowhere;
    }
  }
  return kNowhere;
}

/// Whether a letter can stand beside a dot in a key, or between it and the next part.
bool goes_on(char letter) noexcept {
  constexpr std::string_view kEnds = "\n=,[]{}";
  return kEnds.find(letter) == std::string_view::npos;
}

}  // namespace

std::optional<int> line_of_deeper_key(std::string_view text, std::size_t most) {
  int line = 1;
  std::size_t dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t next = at + 1;
    if (is_quote(text[at])) {
      next = end_of_quoted(text, at);
      if (next == kNowhere) return std::nullopt;
      line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                          text.begin() + static_cast<std::ptrdiff_t>(next), '\n'));
    } else if (text[at] == '#') {
      next = std::min(text.find('\n', at), text.size());
    } else if (text[at] == '.') {
      if (++dots >= most) return line;
    } else if (!goes_on(text[at])) {
      dots = 0;
      line += text[at] == '\n' ? 1 : 0;
    }
    at = next;
  }
  return std::nullopt;
}

}  // namespace carom::io
