// Scene files: what a person, another program or an earlier run wrote, as a Scene.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/base/error.hpp"
#include "carom/run/settings.hpp"
#include "carom/state/scene.hpp"

namespace carom {

/// What a scene file holds.
struct SceneFile {
  Scene scene;
  RunSettings run;
};

/// Reads a scene from a file, "-" for the standard input: TOML, the CollisionSystem text of Sedgewick and Wayne's
/// algs4, or the last frame of an extended XYZ file; told apart by the name's ending and the content.
/// Throws one Error with everything that is wrong in the file, each with file:line:column. Does not ask whether the
/// scene can be simulated: realize() does, and its problems carry the places stored here.
SceneFile read_scene(const std::string& path);

/// The same for a text in memory; `name` is what messages call it, and its ending helps to tell the format.
SceneFile parse_scene(std::string_view text, const std::string& name);

/// Everything that is wrong with a scene file: what read_scene() would throw and, as far as what could be read
/// allows, what realize() would throw, and what `more` finds in the settings. Empty if the scene can be simulated.
/// Throws nothing for bad input.
std::vector<Problem> problems_in(const std::string& path,
                                 const std::function<std::vector<Problem>(const RunSettings&)>& more = {});

/// A scene file in TOML from which parse_scene() makes the same scene and settings, bit for bit.
std::string to_toml(const SceneFile& file);

/// A scene without anything left to choose: the setup's box, physics and disks, one by one, at time 0.
Scene explicit_scene(const Setup& setup, std::string title = {});

}  // namespace carom
