// Small formulas that know their operands: put numbers in, work them out step by step.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "decimal.hpp"

namespace carom::explaining {

struct Node;

/// An immutable formula. Built with + − × ÷ from symbols and whole numbers.
class Expr {
 public:
  Expr(int value);  // NOLINT: 2 * m reads as written
  explicit Expr(Quantity number);
  explicit Expr(Node node);

  const Node& operator*() const { return *node_; }
  const Node* operator->() const { return node_.get(); }

 private:
  std::shared_ptr<const Node> node_;
};

/// `dot` is the scalar product of two vector symbols: shown, never evaluated.
enum class Kind { number, symbol, sum, product, quotient, square, root, negation, vector, point, dot };

/// A symbol's name in plain text and in LaTeX.
struct Name {
  std::string text;
  std::string latex;
};

struct Node {
  Kind kind = Kind::number;
  Quantity number;          ///< of a number
  Name name;                ///< of a symbol
  std::vector<Expr> parts;  ///< operands
  std::vector<bool> minus;  ///< per summand of a sum
};

Expr symbol(std::string text, std::string latex);
Expr operator+(const Expr& a, const Expr& b);
Expr operator-(const Expr& a, const Expr& b);
Expr operator*(const Expr& a, const Expr& b);
Expr operator/(const Expr& a, const Expr& b);
Expr operator-(const Expr& a);
Expr square(const Expr& a);
Expr root(const Expr& a);
Expr vector(const Expr& x, const Expr& y);
Expr point(const Expr& x, const Expr& y);
Expr dot(const Expr& a, const Expr& b);

/// Values of symbols by the symbols' text.
using Values = std::map<std::string, Quantity>;

/// The formula with numbers in place of all symbols. The caller guarantees that every symbol has a value.
Expr substituted(const Expr& formula, const Values& values);

/// Whether nothing is left to be worked out: a number, or a vector of numbers.
bool is_result(const Expr& formula);

/// Whether no symbol occurs in it.
bool is_numeric(const Expr& formula);

/// One step of working out a numeric formula, every new number rounded to so many significant digits: products and
/// powers become numbers, then sums, then quotients and roots. A sum of rounded numbers that cancels to less than
/// 10^-(digits-1) of its largest summand becomes 0.
Expr reduced(const Expr& formula, int digits);

/// The result in one step, rounded once.
Expr result_of(const Expr& formula, int digits);

/// Whether two numeric formulas have exactly the same value.
bool equal_values(const Expr& a, const Expr& b);

}  // namespace carom::explaining
