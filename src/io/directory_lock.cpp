#include "carom/io/directory_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
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

DirectoryLock::~DirectoryLock() { close(descriptor_); }

}  // namespace carom
