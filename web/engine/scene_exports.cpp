// Scenes that the page opens, makes and keeps.
#include <algorithm>
#include <string>

#include "carom/base/error.hpp"
#include "carom/carom/presets.hpp"
#include "exchange.hpp"
#include "scene_reading.hpp"
#include "scenes.hpp"

namespace carom::page {
namespace {

// CollisionSystem text begins with the number of disks and nothing else in its line.
bool begins_with_a_count(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return false;
  const std::size_t end = std::min(text.find_first_not_of("0123456789", start), text.size());
  return end > start && (end == text.size() || text[end] == '\n' || text[end] == '\r');
}

SceneFile made(std::string_view name, double number) {
  if (name == "cradle") return make_cradle(static_cast<std::uint64_t>(number));
  if (name == "galperin") return make_galperin(static_cast<int>(number));
  if (name == "break") return make_break();
  throw Error("there is no preset '" + std::string(name) + "'");
}

constexpr double code_of(Boundary boundary) noexcept { return static_cast<double>(boundary); }

}  // namespace

SceneFile read_scene_text(std::string_view text) {
  const std::string name = "scene";  // as messages call it
  io::ReadScene read = begins_with_a_count(text) ? io::read_algs4(text, name) : io::read_toml(text, name);
  if (!read.problems.empty()) throw Error(std::move(read.problems));
  return std::move(read.file);
}

}  // namespace carom::page

using namespace carom;
using namespace carom::page;

/// Puts the preset named in the input into the text, as TOML. Returns 0 if there is none.
CAROM_EXPORT int carom_preset(double number) {
  return guarded(0, [&] {
    answer(to_toml(made(input(), number)));
    return 1;
  });
}

/// What the scene in the input says: number of disks, width, height, boundary along x and y (0 periodic, 1 reflecting,
/// 2 open), restitution, that of walls; then for each disk x, y, vx, vy, mass, radius. Null with the problems as text.
CAROM_EXPORT double* carom_scene() {
  return guarded<double*>(nullptr, [] {
    const Setup setup = realize(read_scene_text(input()).scene);
    const System& system = setup.system;
    std::vector<double> numbers{static_cast<double>(system.size()),
                                system.box.size.x,
                                system.box.size.y,
                                code_of(system.box.boundary[0]),
                                code_of(system.box.boundary[1]),
                                system.physics.restitution,
                                system.physics.wall_restitution};
    for (std::size_t k = 0; k < system.size(); ++k) {
      const Vec2 x = setup.frame.position(k);
      const Vec2 v = setup.frame.velocity(k);
      numbers.insert(numbers.end(), {x.x, x.y, v.x, v.y, system.mass(k), system.radius(k)});
    }
    return answer_numbers(std::move(numbers));
  });
}
