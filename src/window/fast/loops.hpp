// The hot loops of a window, compiled once for every instruction set.
#pragma once

#include <atomic>

#include "carom/base/simd.hpp"
#include "carom/window/solver.hpp"
#include "workspace.hpp"

namespace carom::fast {

struct Loops {
  /// Predicts the first event of every disk and fills the calendar, then processes the events before `until`.
  /// Returns false if it stopped because `interrupt` became true. Called again, it goes on where it was.
  bool (*process_events)(Workspace& work, double until, const std::atomic<bool>& interrupt) = nullptr;
  /// At the window's end, with all disks at one time: notes in the books how far they overlap.
  void (*note_overlaps)(Workspace& work) = nullptr;
  /// The kernel by itself: times[m] becomes the time at which disk k meets candidate near[m], kNever if it does not.
  /// `near` and `times` go on for another 8 entries, the former with k. For tests and benchmarks.
  void (*contact_times)(const Record* records, Index k, const Index* near, int count, const Shifts& shifts,
                        double* times) = nullptr;
  ListSteps list_steps;
};

/// The loops for these instructions. `one_kind`: all disks have one radius and one mass.
Loops loops_for(Simd simd, Neighbourhood neighbourhood, bool one_kind) noexcept;

/// Those without vector instructions: the prediction is that of carom/predict/contact.hpp itself.
Loops scalar_loops(Neighbourhood neighbourhood, bool one_kind) noexcept;
/// Null where this build has none.
Loops vector_loops(Simd simd, Neighbourhood neighbourhood, bool one_kind) noexcept;

}  // namespace carom::fast
