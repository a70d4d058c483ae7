#include <utility>

#include "carom/io/scene_file.hpp"

namespace carom {

Scene explicit_scene(const Setup& setup, std::string title) {
  const System& system = setup.system;
  Scene scene;
  scene.title = std::move(title);
  scene.size = system.box.size;
  scene.boundary = system.box.boundary;
  scene.restitution = system.physics.restitution;
  if (system.physics.wall_restitution != system.physics.restitution) {
    scene.wall_restitution = system.physics.wall_restitution;
  }
  if (!system.physics.elastic() || system.physics.t_c != 0) scene.t_c = system.physics.t_c;
  scene.disks.reserve(system.size());
  for (std::size_t k = 0; k < system.size(); ++k) {
    scene.disks.push_back({setup.frame.position(k), setup.frame.velocity(k), system.radius(k), system.mass(k), {}});
  }
  return scene;
}

}  // namespace carom
