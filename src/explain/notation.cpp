#include "notation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace carom::explaining {
namespace {

// Writes one formula. `leading` says that a minus sign may stand here without parentheses.
class Writer {
 public:
  explicit Writer(Notation notation) : notation_(notation) {}

  [[nodiscard]] std::string write(const Expr& e, bool leading) const {
    switch (e->kind) {
      case Kind::number: return number(e->number.value, leading);
      case Kind::symbol: return text() ? e->name.text : e->name.latex;
      case Kind::sum: return sum(e);
      case Kind::product: return product(e, leading);
      case Kind::quotient: return quotient(e, leading);
      case Kind::square: return square(e);
      case Kind::root: return root(e);
      case Kind::negation: return in_parentheses_if(!leading, fmt::format("-{}", factor(e->parts[0], false)));
      case Kind::vector: return pair(text() ? "⟨" : "\\langle ", e, text() ? "⟩" : " \\rangle");
      case Kind::point: return pair("(", e, ")");
      case Kind::dot: return write(e->parts[0], false) + times() + write(e->parts[1], false);
    }
    return {};
  }

 private:
  [[nodiscard]] bool text() const { return notation_ == Notation::text; }
  [[nodiscard]] std::string times() const { return text() ? "·" : " \\cdot "; }

  static std::string in_parentheses_if(bool needed, const std::string& inner) {
    return needed ? fmt::format("({})", inner) : inner;
  }

  [[nodiscard]] std::string number(const Decimal& value, bool leading) const {
    return in_parentheses_if(value < 0 && !leading, text() ? plain_number(value) : latex_number(value));
  }

  // Part of a product: everything but numbers, symbols and powers in parentheses.
  [[nodiscard]] std::string factor(const Expr& e, bool leading) const {
    const bool closed = e->kind == Kind::sum || e->kind == Kind::quotient || e->kind == Kind::product;
    return in_parentheses_if(closed, write(e, leading || closed));
  }

  [[nodiscard]] std::string sum(const Expr& e) const {
    std::string line = summand(e->parts[0], true);  // the first summand of a sum is never subtracted
    for (std::size_t k = 1; k < e->parts.size(); ++k) {
      const Expr& part = e->parts[k];
      const bool negative = part->kind == Kind::number && part->number.value < 0 && !e->minus[k];
      const std::string term = negative ? number(-part->number.value, true) : summand(part, false);
      line += kBreak;
      line += e->minus[k] || negative ? "- " : "+ ";
      line += term;
    }
    return line;
  }

  [[nodiscard]] std::string summand(const Expr& e, bool leading) const {
    return in_parentheses_if(e->kind == Kind::sum, write(e, leading || e->kind == Kind::sum));
  }

  [[nodiscard]] std::string product(const Expr& e, bool leading) const {
    std::string line = factor(e->parts[0], leading);
    for (std::size_t k = 1; k < e->parts.size(); ++k) {
      const bool numbers = is_numeric(e->parts[k - 1]) && is_numeric(e->parts[k]);
      line += text() || numbers ? times() : " ";
      line += factor(e->parts[k], false);
    }
    return line;
  }

  [[nodiscard]] std::string quotient(const Expr& e, bool leading) const {
    if (notation_ == Notation::latex)
      return fmt::format("\\frac{{{}}}{{{}}}", unbroken(write(e->parts[0], true)), unbroken(write(e->parts[1], true)));
    const Expr& below = e->parts[1];
    const bool with_power = !text() && below->kind == Kind::number && has_power_of_ten(below->number.value);
    const bool closed = with_power || below->kind == Kind::product || below->kind == Kind::negation;
    const std::string denominator = closed ? in_parentheses_if(true, write(below, true)) : factor(below, false);
    return summand(e->parts[0], leading) + "/" + denominator;
  }

  [[nodiscard]] std::string square(const Expr& e) const {
    const Expr& base = e->parts[0];
    const bool bare = base->kind == Kind::symbol ||
                      (base->kind == Kind::number && base->number.value >= 0 && !has_power_of_ten(base->number.value));
    return in_parentheses_if(!bare, write(base, true)) + (text() ? "²" : "^2");
  }

  [[nodiscard]] std::string root(const Expr& e) const {
    const std::string inner = write(e->parts[0], true);
    if (!text()) return fmt::format("\\sqrt{{{}}}", unbroken(inner));
    return fmt::format("√{}", in_parentheses_if(e->parts[0]->kind != Kind::number, inner));
  }

  // Fractions in the components of a vector are written with a slash.
  [[nodiscard]] std::string pair(const std::string& open, const Expr& e, const std::string& close) const {
    const Writer inner(text() ? Notation::text : Notation::latex_inline);
    return open + inner.write(e->parts[0], true) + "," + kBreak + inner.write(e->parts[1], true) + close;
  }

  Notation notation_;
};

}  // namespace

std::string written(const Expr& formula, Notation notation) { return Writer(notation).write(formula, true); }

std::string written(Relation relation, Notation notation) {
  switch (relation) {
    case Relation::equal: return "=";
    case Relation::about: return notation == Notation::text ? "≈" : "\\approx";
    case Relation::greater: return ">";
    case Relation::less: return "<";
  }
  return {};
}

std::string written_on_one_line(const Chain& chain, Notation notation) {
  return written_on_one_line(chain, chain.members.size(), notation);
}

std::string written_on_one_line(const Chain& chain, std::size_t count, Notation notation) {
  std::string line;
  for (std::size_t k = 0; k < count; ++k) {
    const Member& member = chain.members[k];
    if (k > 0) line += fmt::format(" {} ", written(member.relation, notation));
    line += unbroken(written(member.expression, notation));
  }
  return line;
}

std::size_t head_length(const Chain& chain, int columns) {
  std::size_t count = 2;
  while (count < chain.members.size() && !is_numeric(chain.members[count].expression) &&
         width(written_on_one_line(chain, count + 1, Notation::text)) <= columns)
    ++count;
  return count;
}

std::string unbroken(std::string line) {
  std::replace(line.begin(), line.end(), kBreak, ' ');
  return line;
}

std::vector<std::string> pieces(const std::string& line) {
  std::vector<std::string> result;
  std::size_t start = 0;
  for (std::size_t end; (end = line.find(kBreak, start)) != std::string::npos; start = end + 1)
    result.push_back(line.substr(start, end - start));
  result.push_back(line.substr(start));
  return result;
}

int width(const std::string& utf8) {
  return static_cast<int>(std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace carom::explaining
