#include "carom/window/collision.hpp"

namespace carom {

std::string_view name_of(Wall wall) noexcept {
  switch (wall) {
    case Wall::left: return "left";
    case Wall::right: return "right";
    case Wall::bottom: return "bottom";
    case Wall::top: return "top";
  }
  return "";
}

}  // namespace carom
