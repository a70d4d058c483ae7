// Keeps the numbers as they were printed, and works out new ones from them.
#pragma once

#include <vector>

#include "document.hpp"
#include "expression.hpp"

namespace carom::explaining {

/// The values of all symbols so far. Results are rounded to `digits` significant digits and kept rounded.
class Ledger {
 public:
  explicit Ledger(int digits) : digits_(digits) {}

  /// A given number, kept with all its digits: "m1 = 0.5".
  Chain give(const Expr& name, double value);
  /// A computed number, rounded like every result: "t_c ≈ 2.4".
  Chain give_rounded(const Expr& name, double value);

  /// "name = shown = … = formula = the formula with numbers = worked out step by step = result". What is named, a
  /// symbol or a vector of symbols in `name` or `shown`, has the result as its value from then on.
  Chain derive(const Expr& name, const std::vector<Expr>& shown, const Expr& formula);
  /// The same without the steps between numbers and result.
  Chain derive_at_once(const Expr& name, const std::vector<Expr>& shown, const Expr& formula);

  /// The value of a symbol. The caller guarantees that it has one.
  [[nodiscard]] const Decimal& value(const Expr& name) const { return values_.at(name->name.text).value; }
  /// A formula with numbers in place of symbols.
  [[nodiscard]] Expr with_numbers(const Expr& formula) const { return substituted(formula, values_); }
  [[nodiscard]] int digits() const { return digits_; }

 private:
  Chain derive(const Expr& name, const std::vector<Expr>& shown, const Expr& formula, bool at_once);
  void define(const Expr& name, const Expr& result);

  int digits_;
  Values values_;
};

/// "a = b": an equation that nothing is put into.
Chain statement(const Expr& left, const Expr& right, std::string tag = "");

/// `chain` with an equation number.
Chain tagged(std::string tag, Chain chain);

}  // namespace carom::explaining
