// Where a run keeps its files.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "carom/io/directory_lock.hpp"
#include "carom/run/settings.hpp"

namespace carom {

/// A directory for one run's files. Made ready before the run begins, so that a run's work is not lost at its end, and
/// locked against other runs as long as it or a copy of it lives.
class OutputDirectory {
 public:
  /// Creates the directory and its parents. Throws Error if it cannot be created or written to, if another run is
  /// writing there, or if it holds a run already. With `overwrite` that run's files may stay until remove_old_run().
  explicit OutputDirectory(std::string path, bool overwrite = false);

  /// The directory of a run that is to go on. Throws Error if it cannot be written to or another run is writing there.
  static OutputDirectory of_run(std::string path);

  /// Removes what an earlier run has left: to be called when the new one is sure to start.
  void remove_old_run() const;
  /// Removes what a run that was killed has left half-written.
  void remove_unfinished_files() const;
  /// For a run that is to go on from the checkpoint `path`: makes it the newest here, in one step and on the disk, and
  /// removes what is later. To be called before the run's files are cut back to what it knows, so that at no moment
  /// all checkpoints here are damaged or speak of what was cut off.
  void make_newest(const std::string& path) const;
  /// Throws Error if the directory was deleted or has another in its place.
  void require_still_there() const;

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] std::string report() const { return in("report.json"); }
  [[nodiscard]] std::string scene() const { return in("scene.toml"); }
  [[nodiscard]] std::string final_frame() const { return in("final.xyz"); }
  [[nodiscard]] std::string checkpoint() const { return in("checkpoint.h5"); }
  /// The checkpoint before that one.
  [[nodiscard]] std::string previous_checkpoint() const { return in("checkpoint-1.h5"); }
  [[nodiscard]] std::string trajectory(TrajectoryFormat format = TrajectoryFormat::xyz) const {
    return in(format == TrajectoryFormat::h5md ? "trajectory.h5md" : "trajectory.xyz");
  }
  [[nodiscard]] std::string observables() const { return in("observables"); }  ///< a directory of its own
  [[nodiscard]] std::string in(std::string_view name) const;
  /// The name without folders of a file that lies in this directory, the absolute path of another.
  [[nodiscard]] std::string name_within(const std::string& path) const;

 private:
  OutputDirectory() = default;

  std::string path_;
  std::shared_ptr<const DirectoryLock> lock_;
};

}  // namespace carom
