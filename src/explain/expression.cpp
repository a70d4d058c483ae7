#include "expression.hpp"

#include <algorithm>
#include <utility>

namespace carom::explaining {
namespace {

Expr make(Kind kind, std::vector<Expr> parts) {
  Node node;
  node.kind = kind;
  node.parts = std::move(parts);
  return Expr(std::move(node));
}

// a ± b; a sum on the left is continued, so that a + b + c is one sum.
Expr sum(const Expr& a, const Expr& b, bool minus) {
  Node node;
  node.kind = Kind::sum;
  if (a->kind == Kind::sum) {
    node.parts = a->parts;
    node.minus = a->minus;
  } else {
    node.parts = {a};
    node.minus = {false};
  }
  node.parts.push_back(b);
  node.minus.push_back(minus);
  return Expr(std::move(node));
}

bool is_number(const Expr& e) { return e->kind == Kind::number; }

bool all_numbers(const Expr& e) { return std::all_of(e->parts.begin(), e->parts.end(), is_number); }

template <typename Change>
Expr with_parts(const Expr& e, Change change) {
  Node node = *e;
  for (Expr& part : node.parts) part = change(part);
  return Expr(std::move(node));
}

Decimal value_of(const Expr& e) {
  const auto part = [&](std::size_t k) { return value_of(e->parts[k]); };
  switch (e->kind) {
    case Kind::number: return e->number.value;
    case Kind::square: return part(0) * part(0);
    case Kind::root: return sqrt(part(0));
    case Kind::negation: return -part(0);
    case Kind::quotient: return part(0) / part(1);
    default: break;
  }
  Decimal value = e->kind == Kind::product ? 1 : 0;
  for (std::size_t k = 0; k < e->parts.size(); ++k) {
    if (e->kind == Kind::product) {
      value *= part(k);
    } else {
      value += e->minus[k] ? Decimal(-part(k)) : part(k);
    }
  }
  return value;
}

bool is_exact(const Expr& e) {
  if (is_number(e)) return e->number.exact;
  return std::all_of(e->parts.begin(), e->parts.end(), is_exact);
}

// Whether what is left of a sum is only the rounding of its summands.
bool cancels(const Expr& sum, const Decimal& total, int digits) {
  if (sum->kind != Kind::sum || is_exact(sum)) return false;
  Decimal largest = 0;
  for (const Expr& part : sum->parts) largest = std::max(largest, Decimal(abs(value_of(part))));
  return abs(total) < largest * pow(Decimal(10), 1 - digits);
}

Expr number_from(const Expr& e, int digits) {
  const Decimal value = value_of(e);
  const Decimal shown = cancels(e, value, digits) ? Decimal(0) : rounded(value, digits);
  return Expr(Quantity{shown, is_exact(e) && same(value, shown)});
}

bool is_open_sum(const Expr& e) { return e->kind == Kind::sum && !all_numbers(e); }

}  // namespace

Expr::Expr(int value) : Expr(Quantity{Decimal(value), true}) {}
Expr::Expr(Quantity number) : Expr(Node{Kind::number, std::move(number), {}, {}, {}}) {}
Expr::Expr(Node node) : node_(std::make_shared<const Node>(std::move(node))) {}

Expr symbol(std::string text, std::string latex) {
  return Expr(Node{Kind::symbol, {}, {std::move(text), std::move(latex)}, {}, {}});
}

Expr operator+(const Expr& a, const Expr& b) { return sum(a, b, false); }
Expr operator-(const Expr& a, const Expr& b) { return sum(a, b, true); }

Expr operator*(const Expr& a, const Expr& b) {
  std::vector<Expr> factors = a->kind == Kind::product ? a->parts : std::vector<Expr>{a};
  factors.push_back(b);
  return make(Kind::product, std::move(factors));
}

Expr operator/(const Expr& a, const Expr& b) { return make(Kind::quotient, {a, b}); }
Expr operator-(const Expr& a) { return make(Kind::negation, {a}); }
Expr square(const Expr& a) { return make(Kind::square, {a}); }
Expr root(const Expr& a) { return make(Kind::root, {a}); }
Expr vector(const Expr& x, const Expr& y) { return make(Kind::vector, {x, y}); }
Expr point(const Expr& x, const Expr& y) { return make(Kind::point, {x, y}); }
Expr dot(const Expr& a, const Expr& b) { return make(Kind::dot, {a, b}); }

Expr substituted(const Expr& formula, const Values& values) {
  if (formula->kind == Kind::symbol) return Expr(values.at(formula->name.text));
  Expr result = with_parts(formula, [&](const Expr& part) { return substituted(part, values); });
  if (result->kind != Kind::negation || !is_number(result->parts[0])) return result;
  const Quantity& negated = result->parts[0]->number;  // -0.8 is a number, -0 is 0, -(-0.8) has yet to be worked out
  return negated.value < 0 ? result : Expr(Quantity{-negated.value, negated.exact});
}

bool is_result(const Expr& formula) {
  if (formula->kind == Kind::vector || formula->kind == Kind::point) return all_numbers(formula);
  return is_number(formula);
}

bool is_numeric(const Expr& formula) {
  return formula->kind != Kind::symbol && std::all_of(formula->parts.begin(), formula->parts.end(), is_numeric);
}

Expr reduced(const Expr& formula, int digits) {
  const auto reduce = [&](const Expr& part) { return reduced(part, digits); };
  switch (formula->kind) {
    case Kind::number: return formula;
    case Kind::vector:
    case Kind::point: return with_parts(formula, reduce);
    case Kind::product:
      if (std::none_of(formula->parts.begin(), formula->parts.end(), is_open_sum)) return number_from(formula, digits);
      return with_parts(formula, [&](const Expr& part) { return is_open_sum(part) ? reduce(part) : part; });
    case Kind::quotient:
      if (formula->parts[0]->kind == Kind::negation && is_number(formula->parts[1]))
        return number_from(formula, digits);
      [[fallthrough]];
    case Kind::sum:
    case Kind::root: return all_numbers(formula) ? number_from(formula, digits) : with_parts(formula, reduce);
    default: return number_from(formula, digits);
  }
}

Expr result_of(const Expr& formula, int digits) {
  if (formula->kind != Kind::vector) return number_from(formula, digits);
  return with_parts(formula, [&](const Expr& part) { return number_from(part, digits); });
}

bool equal_values(const Expr& a, const Expr& b) {
  if (a->kind == Kind::vector || a->kind == Kind::point)
    return equal_values(a->parts[0], b->parts[0]) && equal_values(a->parts[1], b->parts[1]);
  return same(value_of(a), value_of(b));
}

}  // namespace carom::explaining
