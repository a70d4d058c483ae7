// The numbers of a scene by name, so that they can be varied.
#pragma once

#include <string>

#include "carom/io/scene_file.hpp"

namespace carom {

/// Puts `value` in the place of what the scene file says under `key`. Keys are those of scene files, "section.key":
/// box.aspect, gas.temperature (of every [[gas]]), gas.2.mass (of the second), disk.1.radius, physics.restitution,
/// run.until, observe.NAME.OPTION …; and these:
///   packing           of all gases together, shared among them as it was; the box follows, with its shape
///   disks or count    of the one gas; where it has a packing fraction the box follows
///   aspect            height/width; the box keeps its area
///   temperature, seed, radius, mass                      the same as gas.temperature …
///   restitution, wall_restitution                        the same as physics.restitution …
///   radius_ratio, mass_ratio                             of the second gas to the first
/// Throws Error if there is no such key, the scene has not what it names, or a count is not a whole number. Ranges are
/// not checked here: the scene file's reader and realize() do that.
void set_scene_key(SceneFile& file, const std::string& key, double value);

/// The key in full: "gas.temperature" for "temperature". Keys without a longer form, and unknown ones, as they are.
std::string full_scene_key(const std::string& key);

}  // namespace carom
