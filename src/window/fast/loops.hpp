// The hot loops of a window, compiled once for every instruction set.
#pragma once

#include <atomic>

#include "carom/base/simd.hpp"
#include "workspace.hpp"

namespace carom::fast {

/// Predicts the first event of every disk and fills the calendar, then processes the events before `until`.
/// Returns false if it stopped because `interrupt` became true. Called again, it goes on where it was.
using ProcessEvents = bool (*)(Workspace& work, double until, const std::atomic<bool>& interrupt);

/// The loop for these instructions; null if it was not compiled.
ProcessEvents process_events_with(Simd simd) noexcept;

/// The loop without vector instructions: the prediction of carom/predict/contact.hpp itself.
bool process_events_scalar(Workspace& work, double until, const std::atomic<bool>& interrupt);
/// Null where this build has no such loop.
ProcessEvents process_events_vector(Simd simd) noexcept;

}  // namespace carom::fast
