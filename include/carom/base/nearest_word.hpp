// What a mistyped name was probably meant to be.
#pragma once

#include <string_view>
#include <vector>

namespace carom {

/// The candidate that differs from `word` by the fewest letters left out, added, changed or swapped; empty if none is
/// close enough to have been meant.
std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace carom
