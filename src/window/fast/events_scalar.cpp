// The events' loop without vector instructions.
#include <atomic>
#include <cmath>

#include "kernel_scalar.hpp"
#include "loops.hpp"
#include "workspace.hpp"

namespace carom::fast::scalar {
using Kernel = ScalarKernel;
}

#define CAROM_TARGET scalar
#define CAROM_INLINE inline
#define CAROM_BEGIN
#define CAROM_END
#include "events-inl.hpp"

namespace carom::fast {

bool process_events_scalar(Workspace& work, double until, const std::atomic<bool>& interrupt) {
  return scalar::process_events(work, until, interrupt);
}

}  // namespace carom::fast
