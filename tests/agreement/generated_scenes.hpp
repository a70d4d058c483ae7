// Scenes of every kind that the solvers must agree on, made from carom's own random numbers.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "carom/state/scene.hpp"

namespace carom::test {

/// A scene that can be simulated, with a name that tells what it is.
struct GeneratedScene {
  std::string name;
  Setup setup;
};

using GeneratedScenes = std::vector<GeneratedScene>;

/// Scenes that have something in common.
struct SceneGroup {
  std::string_view name;
  GeneratedScenes (*make)();
};

/// All groups. The same scenes on every call and every machine.
std::span<const SceneGroup> scene_groups();

}  // namespace carom::test
