// Frames one after another in a file, written while a run goes on and read back afterwards.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "carom/run/settings.hpp"
#include "carom/state/scene.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"

namespace carom {

/// How much of a trajectory there is.
struct TrajectoryLength {
  std::uint64_t frames = 0;
  std::uint64_t bytes = 0;  ///< where the format's frames lie one behind the other, as in extended XYZ; else 0
};

/// A trajectory that grows. Its file can be read at any time, up to the last whole frame.
class TrajectoryWriter {
 public:
  virtual ~TrajectoryWriter() = default;
  TrajectoryWriter() = default;
  TrajectoryWriter(const TrajectoryWriter&) = delete;
  TrajectoryWriter& operator=(const TrajectoryWriter&) = delete;

  /// All of these throw Error with the path and the reason if the file cannot be written.
  virtual void append(const System& system, const Frame& frame) = 0;
  [[nodiscard]] virtual TrajectoryLength length() const noexcept = 0;
  /// Removes what was appended after the trajectory had that length.
  virtual void cut_to(const TrajectoryLength& length) = 0;
  /// Returns when all frames are safe on the disk.
  virtual void sync() = 0;
  virtual void close() = 0;
};

/// Creates a trajectory, or empties the one that is there. `format` is not `none`.
std::unique_ptr<TrajectoryWriter> create_trajectory(const std::string& path, TrajectoryFormat format,
                                                    const System& system);

/// Goes on with a trajectory of this system that is `kept` long or longer. Throws Error if it is shorter. What it has
/// beyond that is still there: cut_to(kept) is to be called before anything is appended.
std::unique_ptr<TrajectoryWriter> continue_trajectory(const std::string& path, TrajectoryFormat format,
                                                      const System& system, const TrajectoryLength& kept);

/// What a frame says before its disks.
struct FrameHeader {
  std::size_t disks = 0;
  double time = 0;
};

/// Reads the frames of a file one after another.
class TrajectoryReader {
 public:
  virtual ~TrajectoryReader() = default;
  TrajectoryReader() = default;
  TrajectoryReader(const TrajectoryReader&) = delete;
  TrajectoryReader& operator=(const TrajectoryReader&) = delete;

  /// The next frame, or nothing at the end. Throws Error if it is malformed.
  virtual std::optional<Setup> next() = 0;
  /// Passes over the next frame, or returns nothing at the end.
  virtual std::optional<FrameHeader> skip() = 0;
  /// Whether the file ended in the middle of a frame, as after a crash: next() and skip() have returned nothing there.
  [[nodiscard]] virtual bool cut_off() const noexcept = 0;
};

/// Opens an extended XYZ or H5MD file, told apart by its content; "-" is extended XYZ on the standard input. Windings
/// are those of the file (H5MD) or 0.
std::unique_ptr<TrajectoryReader> open_trajectory(const std::string& path);

/// Whether a file begins as HDF5 files do. A file that cannot be read does not.
bool is_hdf5_file(const std::string& path);

}  // namespace carom
