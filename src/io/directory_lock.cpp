#include "carom/io/directory_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "carom/base/error.hpp"

namespace carom {

DirectoryLock::DirectoryLock(const std::string& directory)
    : descriptor_(open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) throw Error(std::string("cannot be opened: ") + std::strerror(errno), {directory});
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  throw Error("another carom is at work here", {directory});
}

bool DirectoryLock::is_at(const std::string& path) const noexcept {
  struct stat locked {};
  struct stat found {};
  if (fstat(descriptor_, &locked) != 0) return true;
  return stat(path.c_str(), &found) == 0 && locked.st_dev == found.st_dev && locked.st_ino == found.st_ino;
}

DirectoryLock::~DirectoryLock() { close(descriptor_); }

}  // namespace carom
