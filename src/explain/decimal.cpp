#include "decimal.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace carom::explaining {
namespace {

// More digits than any printed number has: 17 of a double.
constexpr int kPrintedDigits = 20;

// |value| = d.ddd × 10^exponent, without trailing zeros.
struct Scientific {
  std::string digits;
  int exponent = 0;
};

Scientific scientific(const Decimal& value) {
  const std::string text = Decimal(abs(value)).str(kPrintedDigits, std::ios_base::scientific);  // "6.40e-01"
  const std::size_t e = text.find('e');
  Scientific result{text.substr(0, e), std::atoi(text.c_str() + e + 1)};
  std::erase(result.digits, '.');
  result.digits.erase(result.digits.find_last_not_of('0') + 1);
  return result;
}

bool written_with_power(int exponent) { return exponent < -4 || exponent > 9; }

std::string positional(const Scientific& number) {
  const int length = static_cast<int>(number.digits.size());
  if (number.exponent < 0) return fmt::format("0.{}{}", std::string(-number.exponent - 1, '0'), number.digits);
  const int whole = number.exponent + 1;
  if (length <= whole) return number.digits + std::string(whole - length, '0');
  return fmt::format("{}.{}", number.digits.substr(0, whole), number.digits.substr(whole));
}

std::string mantissa(const Scientific& number) {
  if (number.digits.size() == 1) return number.digits;
  return fmt::format("{}.{}", number.digits.substr(0, 1), number.digits.substr(1));
}

std::string written(const Decimal& value, const char* power_format) {
  if (value == 0) return "0";
  const Scientific number = scientific(value);
  const char* const sign = value < 0 ? "-" : "";
  if (!written_with_power(number.exponent)) return fmt::format("{}{}", sign, positional(number));
  return fmt::format(fmt::runtime(power_format), sign, mantissa(number), number.exponent);
}

}  // namespace

Decimal decimal_of(double value) { return Decimal(fmt::format("{}", value)); }

Decimal rounded(const Decimal& value, int digits) {
  if (value == 0) return value;
  return Decimal(value.str(digits - 1, std::ios_base::scientific));
}

bool same(const Decimal& a, const Decimal& b) {
  static const Decimal kNoise("1e-40");
  return abs(a - b) <= kNoise * (abs(a) > abs(b) ? abs(a) : abs(b));
}

std::string plain_number(const Decimal& value) { return written(value, "{}{}e{}"); }

std::string latex_number(const Decimal& value) { return written(value, "{}{} \\times 10^{{{}}}"); }

bool has_power_of_ten(const Decimal& value) { return value != 0 && written_with_power(scientific(value).exponent); }

}  // namespace carom::explaining
