// Loaded before the C library (LD_PRELOAD): lets the n-th call that changes a file fail, as a full disk would.
//
//   FAIL_AT      number of the call that fails, counted from 1; 0: none, they are only counted
//   FAIL_WITH    its errno; ENOSPC by default
//   FAIL_REST    if set, all later calls fail, too: the disk stays full
//   KILL         if set, the process is killed (SIGKILL) in place of a failure
//   COUNT_TO     a file that gets the number of calls at the process's end
//
// Writes to anything but regular files (terminals, pipes) neither count nor fail.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace {

std::atomic<long> calls{0};

long number_of(const char* name) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtol(text, nullptr, 10) : 0;
}

/// Whether the call that comes now is to fail.
bool fails() {
  const long at = number_of("FAIL_AT");
  const long now = ++calls;
  const bool hit = at > 0 && (now == at || (std::getenv("FAIL_REST") != nullptr && now > at));
  if (hit && std::getenv("KILL") != nullptr) kill(getpid(), SIGKILL);
  if (hit) errno = number_of("FAIL_WITH") != 0 ? static_cast<int>(number_of("FAIL_WITH")) : ENOSPC;
  return hit;
}

bool is_file(int descriptor) {
  struct stat about {};
  return fstat(descriptor, &about) == 0 && S_ISREG(about.st_mode);
}

template <typename Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

struct Teller {
  ~Teller() {
    const char* const path = std::getenv("COUNT_TO");
    std::FILE* const file = path != nullptr ? std::fopen(path, "w") : nullptr;
    if (file == nullptr) return;
    std::fprintf(file, "%ld\n", calls.load());
    std::fclose(file);
  }
} teller;

}  // namespace

extern "C" {

ssize_t write(int descriptor, const void* bytes, size_t count) {
  if (is_file(descriptor) && fails()) return -1;
  return real<ssize_t(int, const void*, size_t)>("write")(descriptor, bytes, count);
}

ssize_t pwrite(int descriptor, const void* bytes, size_t count, off_t at) {
  if (is_file(descriptor) && fails()) return -1;
  return real<ssize_t(int, const void*, size_t, off_t)>("pwrite")(descriptor, bytes, count, at);
}

int ftruncate(int descriptor, off_t size) noexcept {
  if (is_file(descriptor) && fails()) return -1;
  return real<int(int, off_t)>("ftruncate")(descriptor, size);
}

int fsync(int descriptor) {
  if (fails()) return -1;
  return real<int(int)>("fsync")(descriptor);
}

int fdatasync(int descriptor) {
  if (fails()) return -1;
  return real<int(int)>("fdatasync")(descriptor);
}

int rename(const char* from, const char* to) noexcept {
  if (fails()) return -1;
  return real<int(const char*, const char*)>("rename")(from, to);
}

}  // extern "C"
