// The events' loop without vector instructions.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>

#include "kernel_scalar.hpp"
#include "loops.hpp"
#include "workspace.hpp"

namespace carom::fast::scalar {
using TargetKernel = ScalarKernel;
}

#define CAROM_TARGET scalar
#define CAROM_INLINE inline
#define CAROM_NOINLINE [[gnu::noinline]]
#define CAROM_BEGIN
#define CAROM_END
#include "events-inl.hpp"

namespace carom::fast {

Loops scalar_loops(Neighbourhood neighbourhood, bool one_kind) noexcept {
  return scalar::loops(neighbourhood, one_kind);
}

}  // namespace carom::fast
