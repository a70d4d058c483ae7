// What `carom sweep --vary` takes.
#pragma once

#include <string>

#include "carom/io/sweep_files.hpp"

namespace carom::program {

/// "KEY=FROM:TO:STEP", TO included up to rounding, or "KEY=A,B,C". Values are rounded to 12 significant digits, so that
/// 0.6 + 3 × 0.01 is 0.63. Throws UsageError for anything else: a step of 0 or away from TO, numbers that are not
/// finite, a value given twice, more than a million values.
VariedKey parse_variation(const std::string& text);

}  // namespace carom::program
