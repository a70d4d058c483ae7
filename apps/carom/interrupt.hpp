// Ctrl-C and SIGTERM: the first asks the run to stop, a second ends the program at once.
#pragma once

#include <atomic>

namespace carom::program {

/// Installs the handlers and returns the flag that the first signal sets.
const std::atomic<bool>& catch_interrupts();

}  // namespace carom::program
