#include "carom/io/collisions_csv.hpp"

#include <fstream>

#include "carom/base/error.hpp"
#include "collision_rows.hpp"

namespace carom {
namespace {

/// What is no log must not be shortened.
const std::string& checked(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(kCollisionsHead.size(), '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  if (!file && !file.eof()) throw Error("cannot be read", {path});
  if (head != kCollisionsHead) throw Error("is not a log of collisions", {path});
  return path;
}

}  // namespace

CollisionsCsv::CollisionsCsv(const std::string& path) : stream_(path) { stream_.write(kCollisionsHead); }
CollisionsCsv::CollisionsCsv(const std::string& path, std::uint64_t kept) : stream_(checked(path), kept) {}

void CollisionsCsv::append(std::span<const Collision> collisions, double window_start) {
  stream_.write(collision_rows(collisions, window_start));
}

}  // namespace carom
