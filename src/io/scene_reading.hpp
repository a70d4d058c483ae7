// What the readers of the three scene formats hand back: what could be read, and what is wrong.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "carom/base/error.hpp"
#include "carom/io/scene_file.hpp"

namespace carom::io {

/// A scene as far as it could be read. Parts that are wrong hold defaults, and are named here.
struct ReadScene {
  SceneFile file;
  std::vector<Problem> problems;
  bool understood = true;                 ///< false if the file's outline is wrong: nothing more can be said then
  bool box_sound = true;                  ///< false if the box's size, aspect or boundary is wrong
  std::vector<std::size_t> faulty_disks;  ///< indices into scene.disks
  std::vector<std::size_t> faulty_gas;    ///< indices into scene.gas
};

ReadScene read_toml(std::string_view text, const std::string& name);
ReadScene read_algs4(std::string_view text, const std::string& name);
ReadScene read_xyz(std::string_view text, const std::string& name);

/// Reads in the format that name and content tell.
ReadScene read_any(std::string_view text, const std::string& name);

/// The same for a file.
ReadScene read_path(const std::string& path);

/// What keeps the sound parts of a scene from being simulated, without repeating what the reader found.
std::vector<Problem> scene_problems(const ReadScene& read);

}  // namespace carom::io
