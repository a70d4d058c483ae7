// The steps of the derivation, from what is given to the check.
#pragma once

#include <array>

#include "carom/explain/explain.hpp"
#include "decimal.hpp"
#include "document.hpp"

namespace carom::explaining {

/// A derivation carried out with a number of significant digits, and what came out.
struct Derivation {
  Document document;
  bool approaching = false;
  std::array<Decimal, 4> after;  ///< v1fx, v1fy, v2fx, v2fy as printed
  bool balanced = true;          ///< momentum and energy of the printed numbers are kept to six digits
};

/// The caller guarantees finite numbers, positive masses, e in [0, 1] and centres that differ.
Derivation derive(const ExplainedCollision& collision, int digits);

}  // namespace carom::explaining
