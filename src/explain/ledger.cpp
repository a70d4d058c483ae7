#include "ledger.hpp"

#include <utility>

#include "notation.hpp"

namespace carom::explaining {
namespace {

// Adds a member unless it reads like the one before it.
void append(Chain& chain, const Expr& expression) {
  if (chain.members.empty()) {
    chain.members.push_back({Relation::equal, expression});
    return;
  }
  const Expr& last = chain.members.back().expression;
  if (written(last, Notation::text) == written(expression, Notation::text)) return;
  const bool numbers = is_numeric(last) && is_numeric(expression);
  const bool equal = !numbers || equal_values(last, expression);
  chain.members.push_back({equal ? Relation::equal : Relation::about, expression});
}

}  // namespace

Chain Ledger::give(const Expr& name, double value) {
  values_[name->name.text] = {decimal_of(value), true};
  return statement(name, with_numbers(name));
}

Chain Ledger::give_rounded(const Expr& name, double value) {
  const Decimal full = decimal_of(value);
  const Decimal shown = rounded(full, digits_);
  values_[name->name.text] = {shown, same(full, shown)};
  Chain chain = statement(name, with_numbers(name));
  if (!same(full, shown)) chain.members.back().relation = Relation::about;
  return chain;
}

Chain Ledger::derive(const Expr& name, const std::vector<Expr>& shown, const Expr& formula) {
  return derive(name, shown, formula, false);
}

Chain Ledger::derive_at_once(const Expr& name, const std::vector<Expr>& shown, const Expr& formula) {
  return derive(name, shown, formula, true);
}

Chain Ledger::derive(const Expr& name, const std::vector<Expr>& shown, const Expr& formula, bool at_once) {
  Chain chain;
  append(chain, name);
  for (const Expr& form : shown) append(chain, form);
  append(chain, formula);
  Expr current = with_numbers(formula);
  append(chain, current);
  if (at_once) append(chain, current = result_of(current, digits_));
  while (!is_result(current)) append(chain, current = reduced(current, digits_));
  define(name, current);
  for (const Expr& form : shown) define(form, current);
  return chain;
}

void Ledger::define(const Expr& name, const Expr& result) {
  if (name->kind == Kind::symbol && result->kind == Kind::number) values_[name->name.text] = result->number;
  if (name->kind == Kind::vector && result->kind == Kind::vector)
    for (std::size_t k = 0; k < 2; ++k) define(name->parts[k], result->parts[k]);
}

Chain statement(const Expr& left, const Expr& right, std::string tag) {
  return {std::move(tag), {{Relation::equal, left}, {Relation::equal, right}}};
}

Chain tagged(std::string tag, Chain chain) {
  chain.tag = std::move(tag);
  return chain;
}

}  // namespace carom::explaining
