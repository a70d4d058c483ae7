// One program at a time.
#pragma once

#include <string>

namespace carom {

/// Keeps other processes from locking the same directory while it lives; the system lets go of it when the process
/// ends, however that happens. Leaves no file behind.
class DirectoryLock {
 public:
  /// Throws Error if the directory cannot be opened, or another process holds it. File systems without locks are taken
  /// to be free.
  explicit DirectoryLock(const std::string& directory);
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

  /// Whether `path` still names the directory that was locked.
  [[nodiscard]] bool is_at(const std::string& path) const noexcept;

 private:
  int descriptor_;
};

}  // namespace carom
