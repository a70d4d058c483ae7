// A run at the start of a window, in a file: all that is needed to go on as if it had never stopped.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/base/error.hpp"
#include "carom/run/settings.hpp"
#include "carom/run/simulation.hpp"
#include "carom/run/sums.hpp"

namespace carom {

/// How much of a run's growing files belongs to the time before the checkpoint.
struct WrittenFiles {
  std::uint64_t frames = 0;            ///< of the trajectory
  std::uint64_t trajectory_bytes = 0;  ///< of an extended XYZ trajectory
  /// The collision log: a name without folders if it is in the run's own directory, else its absolute path; absent
  /// without a log.
  std::optional<std::string> log = {};
  std::uint64_t log_bytes = 0;
};

struct Checkpoint {
  Snapshot snapshot;
  RunSettings settings;
  std::string title;         ///< of the scene
  std::string scene_digest;  ///< of the setup at time 0
  WrittenFiles files;
  std::uint64_t quiet_windows = 0;  ///< windows without a collision since the last one
  double wall_seconds = 0;          ///< spent so far
  SavedSums sums;                   ///< of the observables
  /// The frame at time 0 if there are observables: what they measure by default depends on it. Without windings.
  std::optional<Frame> start = {};
};

/// Whether this build can write and read checkpoints: it was made with HDF5.
bool has_checkpoints() noexcept;

/// Whether a file begins as a checkpoint does. One that cannot be read does not.
bool is_checkpoint(std::string_view bytes) noexcept;
bool is_checkpoint_file(const std::string& path);

/// The content of a checkpoint file: a line of text with version, length and XXH3 of what follows, then an HDF5 file.
/// docs/files.md has the schema. Throws Error in a build without HDF5, as do the others.
std::string checkpoint_bytes(const Checkpoint& checkpoint);

/// Replaces `path` atomically, synced to the disk before and after; what was there before is kept as `previous`.
void write_checkpoint(const std::string& path, const std::string& previous, const Checkpoint& checkpoint);

/// Throws Error naming what is wrong: a file cut off or changed by a single bit, one of a newer version, or a state
/// that no run can have reached. `name` is what messages call the file.
Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name);
Checkpoint read_checkpoint(const std::string& path);

/// A checkpoint, and what was wrong with newer ones.
struct NewestCheckpoint {
  Checkpoint checkpoint;
  std::string path;
  std::vector<Problem> damaged = {};
};

/// The first of these files that is whole; those that are not there do not count. Absent if there is none of them,
/// throws Error with what is wrong with each if all are damaged. One that cannot be read at all may be whole: then
/// this throws Error, too, whatever comes after it.
std::optional<NewestCheckpoint> read_newest_checkpoint(const std::vector<std::string>& paths);

}  // namespace carom
