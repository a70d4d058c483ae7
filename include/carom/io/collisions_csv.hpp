// The collision log as a table.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "carom/io/file.hpp"
#include "carom/window/collision.hpp"

namespace carom {

/// A CSV file with one row per collision: time,i,j,x,y,nx,ny,impulse, numbers with 17 significant digits; j is a disk
/// or left, right, bottom, top; (x, y) the point of contact; (nx, ny) the unit normal from i to j.
class CollisionsCsv {
 public:
  /// Creates the file with its header line. Throws Error if that fails, as do the others.
  explicit CollisionsCsv(const std::string& path);
  /// Goes on with a log of `kept` bytes or more, and changes nothing in it. Throws Error if it has fewer or does not
  /// begin as a log does.
  CollisionsCsv(const std::string& path, std::uint64_t kept);

  /// Appends rows; `window_start` is the time from which the collisions' own times count.
  void append(std::span<const Collision> collisions, double window_start);
  /// Removes what follows the first bytes.
  void cut_to(std::uint64_t size) { stream_.cut_to(size); }
  void flush() { stream_.flush(); }
  void sync() { stream_.sync(); }
  [[nodiscard]] std::uint64_t size() const noexcept { return stream_.size(); }
  void close() { stream_.close(); }

 private:
  OutputStream stream_;
};

}  // namespace carom
