// The last step of a derivation: impulse, momentum and energy of the numbers printed.
#pragma once

#include "document.hpp"
#include "ledger.hpp"
#include "symbols.hpp"

namespace carom::explaining {

struct Balance {
  Step step;
  bool holds = true;  ///< momentum is kept and energy is kept or lost as it should, to six digits
};

/// The caller guarantees that the ledger holds all velocities before and after (and the energy lost if not elastic).
Balance balance_of(const Symbols& symbols, Ledger& ledger, bool elastic);

}  // namespace carom::explaining
