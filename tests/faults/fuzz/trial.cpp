// Takes the place of carom::io's try_in_child() in fuzzers. HDF5 may crash on damaged files, and the child process
// keeps that from users; what crashes there in our own code, or in HDF5 because we lied to it, is to be found all the
// same.
#include "io/hdf5/trial.hpp"

#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string_view>

#include "carom/base/error.hpp"

namespace carom::io {
namespace {

constexpr int kFaultOfHdf5 = 90;
constexpr unsigned kMostSeconds = 5;

/// Whether one of the innermost frames of the next stack in the report is the library's. Cuts the report after them.
bool in_hdf5(std::string_view& report) {
  constexpr int kInnermost = 4;  // the first may be memcpy's or malloc's
  for (int k = 0; k < kInnermost; ++k) {
    const std::size_t begin = report.find("    #");
    if (begin == std::string_view::npos) return false;
    const std::string_view line = report.substr(begin, report.find('\n', begin) - begin);
    report.remove_prefix(begin + line.size());
    for (const std::string_view library : {"libhdf5", "libsz", "libaec", "libz."}) {
      if (line.find(library) != std::string_view::npos) return true;
    }
  }
  return false;
}

/// A fault of the library is one in its code that is not about memory of ours.
bool is_fault_of_hdf5(std::string_view report) {
  if (!in_hdf5(report)) return false;
  const std::size_t allocated = report.find("allocated by thread");
  if (allocated == std::string_view::npos) return true;
  report.remove_prefix(allocated);
  return in_hdf5(report);
}

void on_report(const char* report) {
  if (is_fault_of_hdf5(report)) ::_exit(kFaultOfHdf5);
}

[[noreturn]] void read_and_exit(const std::function<void()>& reading) {
  __sanitizer_set_death_callback([] {});  // libFuzzer's would keep the input
  __asan_set_error_report_callback(on_report);
  for (const int number : {SIGABRT, SIGALRM}) std::signal(number, SIG_DFL);
  ::alarm(kMostSeconds);
  try {
    reading();
  } catch (const Error&) {
    // The parent will meet it, too.
  }
  ::_exit(0);
}

}  // namespace

void try_in_child(const std::function<void()>& reading, const std::string& file, double) {
  const pid_t child = ::fork();
  if (child == 0) read_and_exit(reading);
  if (child < 0) std::abort();
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  const bool hung = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
  if (hung || (WIFEXITED(status) && WEXITSTATUS(status) == kFaultOfHdf5)) {
    throw Error("is damaged: HDF5 does not survive it", {file});
  }
  std::abort();  // with the sanitizer's report above
}

}  // namespace carom::io
