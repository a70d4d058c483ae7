// Numbers with their standard error, as physicists print them.
#pragma once

#include <optional>
#include <string>

namespace carom {

/// "9.1293(17)" for 9.1293 ± 0.0017: in brackets the error in units of the last digit shown, with two digits if it
/// begins with 1 or 2 and with one otherwise. Very large and very small values get an exponent, "1.23(3)e-12", as do
/// those whose last certain digit stands before the point. Without an error, or
/// with one that is no more than rounding: six digits.
std::string with_error(double value, std::optional<double> error);

}  // namespace carom
