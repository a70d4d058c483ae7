// How deep the keys of a TOML file go, found out before it is parsed.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace carom::io {

/// The line of the first key with more than `most` parts (a.b.c has three), if there is one before the text's first
/// fault. toml++ makes a table of each part, and what walks or removes such tables calls itself once per part: the
/// stack would not last.
std::optional<int> line_of_deeper_key(std::string_view text, std::size_t most);

}  // namespace carom::io
