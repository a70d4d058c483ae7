// LaTeX for chains and rows, shared by Markdown and the LaTeX document.
#pragma once

#include <string>

#include "document.hpp"

namespace carom::explaining {

/// Body of a displayed equation: one line, or an `aligned` environment with a line per member.
std::string displayed(const Chain& chain);

/// The same for several chains side by side; they stand below each other where they are too long for one line.
std::string displayed(const Row& row);

}  // namespace carom::explaining
