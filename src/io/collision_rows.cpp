#include "collision_rows.hpp"

#include <fmt/format.h>

#include <iterator>

namespace carom {

std::string collision_rows(std::span<const Collision> collisions, double window_start) {
  fmt::memory_buffer rows;
  const auto end = std::back_inserter(rows);
  for (const Collision& collision : collisions) {
    fmt::format_to(end, "{:.17g},{},", window_start + collision.time, collision.i);
    if (is_wall(collision.j)) {
      fmt::format_to(end, "{}", name_of(wall_of(collision.j)));
    } else {
      fmt::format_to(end, "{}", collision.j);
    }
    fmt::format_to(end, ",{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", collision.point.x, collision.point.y,
                   collision.normal.x, collision.normal.y, collision.impulse);
  }
  return fmt::to_string(rows);
}

}  // namespace carom
