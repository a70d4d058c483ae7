#include "generated_scenes.hpp"

#include <array>

#include "scene_makers.hpp"

namespace carom::test {

std::span<const SceneGroup> scene_groups() {
  static constexpr std::array kGroups{
      SceneGroup{"gases", gases},
      SceneGroup{"dense_lattices", dense_lattices},
      SceneGroup{"mixtures", mixtures},
      SceneGroup{"granular", granular},
      SceneGroup{"tied_lattices", tied_lattices},
      SceneGroup{"symmetric", symmetric},
      SceneGroup{"touching", touching},
      SceneGroup{"uneven_speeds", uneven_speeds},
      SceneGroup{"pistons", pistons},
      SceneGroup{"long_flights", long_flights},
      SceneGroup{"narrow_boxes", narrow_boxes},
      SceneGroup{"elongated_boxes", elongated_boxes},
      SceneGroup{"open_plane", open_plane},
      SceneGroup{"units", units},
      SceneGroup{"large", large},
  };
  return kGroups;
}

}  // namespace carom::test
