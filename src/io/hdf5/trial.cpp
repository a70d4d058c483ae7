#include "trial.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "carom/base/error.hpp"
#include "handle.hpp"

namespace carom::io {
namespace {

/// Nobody is to see the child's end: no message, no core file, no handler of ours. Ctrl-C is for the parent to heed: a
/// child that it has ended would look like one that has crashed.
void go_quietly() {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) std::signal(number, SIG_DFL);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_IGN);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
}

/// The child has copies of the parent's locks on directories, and is not to keep them when the parent is killed.
void die_with(pid_t parent) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
#endif
}

[[noreturn]] void read_and_exit(const std::function<void()>& reading, pid_t parent) {
  die_with(parent);
  go_quietly();
  try {
    reading();
  } catch (...) {
    // Whatever it is, the parent will meet it, too.
  }
  ::_exit(0);
}

/// Whether the other end of the pipe, which lives as long as the child, was closed in time.
bool ends_within(int pipe, double seconds) {
  pollfd wait{pipe, POLLIN, 0};
  int ready = 0;
  do {
    ready = ::poll(&wait, 1, static_cast<int>(seconds * 1000));
  } while (ready < 0 && errno == EINTR);
  return ready != 0;
}

}  // namespace

void try_in_child(const std::function<void()>& reading, const std::string& file, double seconds) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return;  // out of descriptors: the file itself cannot be opened then
  const pid_t parent = ::getpid();
  const pid_t child = fork_outside_hdf5();
  if (child == 0) read_and_exit(reading, parent);
  ::close(pipe[1]);
  if (child < 0) {
    ::close(pipe[0]);
    throw NotTried("cannot be read: no process can be started to try it", {file});
  }
  const bool in_time = ends_within(pipe[0], seconds);
  if (!in_time) ::kill(child, SIGKILL);
  ::close(pipe[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!in_time) throw NotTried("cannot be read: HDF5 does not come to an end with it", {file});
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) {
    throw NotTried("cannot be read: the process that tried it was killed", {file});
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Error("is damaged: HDF5 crashes on it", {file});
}

}  // namespace carom::io
