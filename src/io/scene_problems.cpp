// The problems of a scene that could be read only in part: faulty parts are replaced by something harmless, and what
// realize() says about the replacements is left out.
#include <algorithm>
#include <limits>
#include <tuple>

#include "scene_reading.hpp"

namespace carom::io {
namespace {

/// Moves faulty disks to the left of everything, where they overlap with nothing. Their ids stay taken, so that
/// messages name the other disks rightly. They take the size of a sound disk, which tells nothing new about the box.
void set_aside_faulty_disks(Scene& scene, const std::vector<std::size_t>& faulty) {
  std::vector<bool> is_faulty(scene.disks.size(), false);
  for (const std::size_t k : faulty) is_faulty[k] = true;
  double left = 0;
  double radius = 0;
  for (std::size_t k = 0; k < scene.disks.size(); ++k) {
    if (is_faulty[k]) continue;
    left = std::min(left, scene.disks[k].position.x);
    radius = std::max(radius, scene.disks[k].radius);
  }
  for (const std::size_t k : faulty) {
    left -= 4 * radius;
    scene.disks[k] = {
        .position = {left, 0}, .velocity = {}, .radius = radius, .mass = 1, .place = scene.disks[k].place};
  }
}

/// A gas with a radius that is no number is refused before anything is placed.
void set_aside(GasSpec& gas) { gas.radius = std::numeric_limits<double>::quiet_NaN(); }

/// Without its box a scene still has disks, which may overlap.
void set_aside_faulty_box(Scene& scene) {
  scene.size.reset();
  scene.boundary = {Boundary::open, Boundary::open};
  scene.gas.clear();
}

bool same_place(const Place& a, const Place& b) noexcept {
  return std::tie(a.file, a.line, a.column) == std::tie(b.file, b.line, b.column);
}

}  // namespace

std::vector<Problem> scene_problems(const ReadScene& read) {
  if (!read.understood) return {};
  Scene scene = read.file.scene;
  std::vector<Place> faulty_places;
  for (const std::size_t k : read.faulty_disks) faulty_places.push_back(scene.disks[k].place);
  set_aside_faulty_disks(scene, read.faulty_disks);
  for (std::size_t g = 0; g < scene.gas.size(); ++g) {
    const bool sound = std::find(read.faulty_gas.begin(), read.faulty_gas.end(), g) == read.faulty_gas.end();
    if (sound && read.faulty_disks.empty()) continue;  // a gas is placed around the disks
    faulty_places.push_back(scene.gas[g].place);
    set_aside(scene.gas[g]);
  }
  if (!read.box_sound) set_aside_faulty_box(scene);
  const bool no_sound_disk = scene.disks.size() == read.faulty_disks.size();
  if (no_sound_disk && (!read.box_sound || !scene.disks.empty())) return {};

  std::vector<Problem> problems = problems_of(scene);
  std::erase_if(problems, [&](const Problem& problem) {
    return std::any_of(faulty_places.begin(), faulty_places.end(),
                       [&](const Place& place) { return same_place(place, problem.place); });
  });
  for (Problem& problem : problems) {
    if (problem.place.file.empty()) problem.place.file = scene.box_place.file;
  }
  return problems;
}

}  // namespace carom::io
