// How long a window is. Chosen from system, state and the contacts counted in the window before; never from end times,
// output, threads or solver.
#pragma once

#include <cstdint>

#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// Contacts per disk that a window should hold. So many that what each window costs once is little beside them; fewer
/// in systems that are divided into patches, because influence reaches less far into shorter windows, above all where
/// disks fly far.
double contacts_per_window(const System& system) noexcept;

/// Length (time, a power of two) of the first window: about contacts_per_window at the collision rate of a gas of
/// this density and temperature, and not so long that the fastest disk could cross a periodic box more than a few
/// times; 1 where nothing moves.
double first_window_length(const System& system, const State& state) noexcept;

/// Contacts per disk to expect in the window that starts with this state, at the collision rate of a gas of this
/// density and temperature; 0 where nothing moves.
double expected_contacts(const System& system, const State& state) noexcept;

/// Length of the window after one that held `events` contacts: half as long if it held more than twice what it
/// should, twice as long if less than a third, within what flight across the box allows, and such that its start
/// and end are exact. `after` is the state at its start, `after.clock` the finished window's with the new start.
double next_window_length(const System& system, const State& after, std::uint64_t events) noexcept;

}  // namespace carom
