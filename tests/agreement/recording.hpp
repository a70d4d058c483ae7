// Everything that can be seen of a run, kept so that two runs can be held against each other.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/run/simulation.hpp"

namespace carom::test {

/// A simulation seen at one time.
struct Glimpse {
  Frame frame;
  Books books{0};
  std::vector<Collision> events;  ///< of this window so far, in log order
};

/// One window: probes inside it, and its end.
struct WindowTrace {
  std::vector<Glimpse> probes;
  Glimpse end;
  State after;  ///< with the next window's clock and the disks' last contacts
};

struct Recording {
  std::vector<WindowTrace> windows;

  [[nodiscard]] const Books& books() const { return windows.back().end.books; }
};

/// Where a recording ends: after `windows` windows, but as soon as there were so many events in three windows or more.
struct Extent {
  std::uint64_t windows = 32;
  std::uint64_t events = 2500;
  int probes = 2;  ///< times at which a window is looked at inside, at most 2
};

/// Runs `setup` and looks at it inside every window and at its end.
Recording record(Simulation& simulation, const Extent& extent = {});
Recording record(const Setup& setup, const SolverOptions& options, const Extent& extent = {});

/// The first thing in which two recordings differ by a bit, with the window and the event; nothing if they are equal.
std::optional<std::string> first_difference(const Recording& expected, const Recording& actual);

}  // namespace carom::test
