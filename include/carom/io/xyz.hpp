// Frames as extended XYZ text, the format that OVITO and ASE read.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "carom/state/scene.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// One frame in extended XYZ, numbers with 17 significant digits so that they read back to the same bits. Species are
/// named as the chemical elements in their order, H, He, Li, … (X beyond the 118th); z is 0. Beside what the format
/// asks for, the comment line has `boundary`, and where they differ from the format's own notions `box` (open axes) and
/// `restitution`, `wall_restitution`, `t_c` (e < 1). Winding numbers are not written.
std::string xyz_frame(const System& system, const Frame& frame);

/// Reads the frames of an extended XYZ file one after another. Columns may stand in any order; pos, velo and radius
/// are required, mass is 1 if absent; disks are ordered by id if there is one.
class XyzReader {
 public:
  /// Opens a file, "-" for the standard input. Throws Error if that fails.
  explicit XyzReader(const std::string& path);
  ~XyzReader();
  XyzReader(XyzReader&&) noexcept;
  XyzReader& operator=(XyzReader&&) noexcept;

  /// The next frame (windings 0), or nothing at the end. Throws Error with every problem, each with file:line:column.
  std::optional<Setup> next();

  /// From now on a last frame, after others, that is cut off, as a crash leaves it, ends the file without an Error;
  /// cut_off() tells.
  void allow_cut_off();
  [[nodiscard]] bool cut_off() const noexcept;

  /// What a frame says before its disks.
  struct Header {
    std::size_t disks = 0;
    double time = 0;
  };
  /// Passes over the next frame, or returns nothing at the end. Throws Error if its first two lines are malformed or
  /// it is cut off.
  std::optional<Header> skip();

 private:
  class Source;
  std::unique_ptr<Source> source_;
};

/// The last frame of an extended XYZ file. Throws Error if there is none or it is malformed.
Setup read_last_frame(const std::string& path);

}  // namespace carom
