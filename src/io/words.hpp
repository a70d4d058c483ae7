// A line of text as words, each with the column that it starts in.
#pragma once

#include <string_view>
#include <vector>

namespace carom::io {

struct Word {
  std::string_view text;
  int column = 0;  ///< of its first byte, counted from 1
};

/// Splits a line at blanks and tabs (and a carriage return at its end) into `words`, which is cleared first.
void split_words(std::string_view line, std::vector<Word>& words);

/// Takes the first line off `text` and returns it without its line feed.
std::string_view take_line(std::string_view& text) noexcept;

}  // namespace carom::io
