// A scene as a person describes it, and what becomes of it: a system and its first frame.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/base/error.hpp"
#include "carom/base/vec2.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// One disk, given in full.
struct DiskSpec {
  Vec2 position = {};
  Vec2 velocity = {};
  double radius = 0.5;
  double mass = 1;
  Place place = {};  ///< where it was read; empty if it was made by a program
};

/// Where the disks of a gas start.
enum class GasStart {
  lattice,  ///< on the loosest triangular lattice that fits into the box
  random    ///< one after another at random places, wherever there is room
};

/// Many equal disks with velocities from Maxwell's distribution.
struct GasSpec {
  std::optional<std::uint64_t> count = {};  ///< if absent, from packing_fraction and the box's size
  /// Area of this gas's disks over that of the box; sets the box if it has no size.
  std::optional<double> packing_fraction = {};
  double radius = 0.5;
  double mass = 1;
  double temperature = 1;  ///< kT, in mass × length²/time²
  std::uint64_t seed = 1;  ///< of places and velocities; with several gases every seed matters to all of them
  GasStart start = GasStart::lattice;
  Place place = {};
};

/// What a scene file says of the initial state and of the physics.
struct Scene {
  std::string title;
  std::optional<Vec2> size;      ///< of the box; if absent, from the gas's packing fraction
  std::optional<double> aspect;  ///< height/width, where the packing fraction sets the size; 1 if absent
  std::array<Boundary, 2> boundary{Boundary::periodic, Boundary::periodic};
  std::vector<DiskSpec> disks;
  std::vector<GasSpec> gas;
  double restitution = 1;
  std::optional<double> wall_restitution;  ///< the same as `restitution` if absent
  std::optional<double> t_c;               ///< see Physics::t_c; if absent, default_t_c()
  Place box_place;
  Place physics_place;
};

/// A scene with every choice made: ids are given to the explicit disks first, then to each gas in turn.
struct Setup {
  System system;
  Frame frame;  ///< at time 0
};

/// The most disks that a scene may have: as many as this machine's memory holds, and no more than ids there are.
double most_disks() noexcept;

/// Makes all choices and checks the result. Throws Error with every problem found, each with its place.
Setup realize(const Scene& scene);

/// Everything that is wrong with a scene: what realize() would throw. Empty if it can be simulated.
std::vector<Problem> problems_of(const Scene& scene);

/// t_c for restitution < 1 where a scene gives none: a millionth of the time in which the root mean square speed covers
/// the mean diameter; 0 where nothing moves.
double default_t_c(const System& system, const Frame& frame) noexcept;

/// State at the start of window 0: `setup`'s frame with positions wrapped and windings at 0, no last contacts; the
/// window's length is left at 1 (choosing it is first_window_length's).
State initial_state(const Setup& setup);

}  // namespace carom
