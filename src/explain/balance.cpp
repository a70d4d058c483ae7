#include "balance.hpp"

#include <tuple>
#include <utility>

namespace carom::explaining {
namespace {

const char* const kRoundingOfLoss =
    ", to six digits of the energy before; the rest is the rounding of the numbers shown.";
const char* const kRounding = " to six digits; the rest is the rounding of the numbers shown.";

Expr energy_of(const Expr& mass, const Expr& vx, const Expr& vy) { return mass * (square(vx) + square(vy)) / 2; }

Decimal speed(const Decimal& vx, const Decimal& vy) { return sqrt(Decimal(vx * vx + vy * vy)); }

// How far two numbers may differ when they agree to six digits of `scale`.
bool agree(const Decimal& a, const Decimal& b, const Decimal& scale) { return abs(a - b) <= scale * Decimal("5e-7"); }

class Auditor {
 public:
  Auditor(const Symbols& symbols, Ledger& ledger) : s_(symbols), ledger_(ledger) {}

  Balance audit(bool elastic) {
    impulse();
    momentum();
    energy(elastic);
    return std::move(balance_);
  }

 private:
  void add(Block block) { balance_.step.blocks.push_back(std::move(block)); }
  void say(std::vector<Run> runs) { add(Paragraph{std::move(runs)}); }
  [[nodiscard]] Decimal value(const Expr& name) const { return ledger_.value(name); }

  void impulse();
  void momentum();
  void energy(bool elastic);

  const Symbols& s_;
  Ledger& ledger_;
  Balance balance_{{"The check: impulse, momentum, energy", {}}, true};
};

void Auditor::impulse() {
  const auto& [one, two] = std::tie(s_.one, s_.two);
  say({"Disk 2 has received an impulse along the normal, and disk 1 the opposite:"});
  add(ledger_.derive(s_.j, {}, (1 + s_.e) * one.m * two.m * (one.vn - two.vn) / (one.m + two.m)));
  add(ledger_.derive(vector(s_.jx, s_.jy), {s_.j * s_.un}, vector(s_.j * s_.unx, s_.j * s_.uny)));
}

void Auditor::momentum() {
  const auto& [one, two] = std::tie(s_.one, s_.two);
  say({"Momentum before and after:"});
  add(ledger_.derive(vector(s_.px, s_.py), {one.m * one.v + two.m * two.v},
                     vector(one.m * one.vx + two.m * two.vx, one.m * one.vy + two.m * two.vy)));
  add(ledger_.derive(vector(s_.pxf, s_.pyf), {one.m * one.vf + two.m * two.vf},
                     vector(one.m * one.vfx + two.m * two.vfx, one.m * one.vfy + two.m * two.vfy)));
  const Decimal scale =
      value(one.m) * speed(value(one.vx), value(one.vy)) + value(two.m) * speed(value(two.vx), value(two.vy));
  if (value(s_.px) == value(s_.pxf) && value(s_.py) == value(s_.pyf)) {
    say({"Momentum is kept."});
  } else if (agree(value(s_.px), value(s_.pxf), scale) && agree(value(s_.py), value(s_.pyf), scale)) {
    say({"Momentum is kept", kRounding});
  } else {
    balance_.holds = false;
    say({"The difference is the rounding of the numbers shown."});
  }
}

void Auditor::energy(bool elastic) {
  const auto& [one, two] = std::tie(s_.one, s_.two);
  say({"Kinetic energy before and after:"});
  add(ledger_.derive(s_.k, {}, energy_of(one.m, one.vx, one.vy) + energy_of(two.m, two.vx, two.vy)));
  add(ledger_.derive(s_.kf, {}, energy_of(one.m, one.vfx, one.vfy) + energy_of(two.m, two.vfx, two.vfy)));
  if (!elastic) add(ledger_.derive(s_.k - s_.kf, {}, s_.k - s_.kf));
  const Decimal lost = elastic ? Decimal(0) : value(s_.lost);
  const Decimal excess = value(s_.kf) + lost;
  std::vector<Run> verdict{"Kinetic energy is kept"};
  if (!elastic) verdict = {"What is missing is ", s_.lost, ", the energy lost"};
  if (value(s_.k) == excess) {
    verdict.emplace_back(".");
  } else if (agree(value(s_.k), excess, value(s_.k))) {
    verdict.emplace_back(elastic ? kRounding : kRoundingOfLoss);
  } else {
    balance_.holds = false;
    verdict = {"The difference is the rounding of the numbers shown."};
  }
  say(std::move(verdict));
}

}  // namespace

Balance balance_of(const Symbols& symbols, Ledger& ledger, bool elastic) {
  return Auditor(symbols, ledger).audit(elastic);
}

}  // namespace carom::explaining
