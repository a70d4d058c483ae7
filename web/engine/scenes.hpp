// Scenes from text in memory: TOML, or the CollisionSystem text of algs4.
#pragma once

#include <string_view>

#include "carom/io/scene_file.hpp"

namespace carom::page {

/// Throws Error with everything that is wrong in the text.
SceneFile read_scene_text(std::string_view text);

}  // namespace carom::page
