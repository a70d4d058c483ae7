// Where a run keeps its files.
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// A directory for one run's files. Made ready before the run begins, so that a run's work is not lost at its end.
class OutputDirectory {
 public:
  /// Creates the directory and its parents. Throws Error if it cannot be created or written to, or if it holds a run
  /// already; with `overwrite` that run's files are removed.
  explicit OutputDirectory(std::string path, bool overwrite = false);

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  [[nodiscard]] std::string report() const { return in("report.json"); }
  [[nodiscard]] std::string scene() const { return in("scene.toml"); }
  [[nodiscard]] std::string final_frame() const { return in("final.xyz"); }
  [[nodiscard]] std::string trajectory() const { return in("trajectory.xyz"); }
  [[nodiscard]] std::string observables() const { return in("observables"); }  ///< a directory of its own

 private:
  [[nodiscard]] std::string in(std::string_view name) const;

  std::string path_;
};

}  // namespace carom
