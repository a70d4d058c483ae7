#include "carom/io/collisions_csv.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string_view>

#include "carom/base/error.hpp"

namespace carom {
namespace {

constexpr std::string_view kHead = "time,i,j,x,y,nx,ny,impulse\n";

/// What is no log must not be shortened.
const std::string& checked(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(kHead.size(), '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  if (!file && !file.eof()) throw Error("cannot be read", {path});
  if (head != kHead) throw Error("is not a log of collisions", {path});
  return path;
}

}  // namespace

CollisionsCsv::CollisionsCsv(const std::string& path) : stream_(path) { stream_.write(kHead); }
CollisionsCsv::CollisionsCsv(const std::string& path, std::uint64_t kept) : stream_(checked(path), kept) {}

void CollisionsCsv::append(std::span<const Collision> collisions, double window_start) {
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
  stream_.write({rows.data(), rows.size()});
}

}  // namespace carom
