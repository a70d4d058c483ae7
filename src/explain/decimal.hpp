// Decimal floating point: numbers that are calculated with exactly as they are printed.
#pragma once

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <string>

namespace carom::explaining {

using Decimal = boost::multiprecision::cpp_dec_float_50;

/// A decimal number, and whether it is free of rounding from the given numbers on.
struct Quantity {
  Decimal value = 0;
  bool exact = true;
};

/// The shortest decimal number that reads back as `value`: what the user typed, as far as can be known.
Decimal decimal_of(double value);

/// `value` rounded to so many significant digits.
Decimal rounded(const Decimal& value, int digits);

/// Equal but for the last of the 50 digits that are calculated with (a quotient leaves noise there).
bool same(const Decimal& a, const Decimal& b);

/// "0.64", "-12", "1.2e-9": without trailing zeros, never "-0".
std::string plain_number(const Decimal& value);

/// The same in LaTeX: "1.2 \times 10^{-9}".
std::string latex_number(const Decimal& value);

/// Whether the number is written with a power of ten.
bool has_power_of_ten(const Decimal& value);

}  // namespace carom::explaining
