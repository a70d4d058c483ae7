#include "helper.hpp"

#include <dlfcn.h>
#include <execinfo.h>
#include <hdf5.h>
#include <poll.h>
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "io/hdf5/trial.hpp"

// Where clang keeps the counters of what is covered.
extern "C" {
extern std::uint8_t counters_begin[] __asm__("__start___sancov_cntrs");
extern std::uint8_t counters_end[] __asm__("__stop___sancov_cntrs");
}

namespace carom::test {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;
constexpr int kInputsPerHelper = 2000;  // what HDF5 does to the memory of others without notice ends with it
constexpr int kFaultOfHdf5 = 90;
constexpr int kHangInHdf5 = 91;
constexpr int kMostSeconds = 1;  // of processor time

constexpr int kMostFrames = 64;

/// Whether a line of a report or a file of code is that of HDF5 or of a library that it calls.
bool is_of_hdf5(std::string_view text) {
  constexpr std::array<std::string_view, 4> kLibraries{"libhdf5", "libsz", "libaec", "libz."};
  return std::any_of(kLibraries.begin(), kLibraries.end(),
                     [&](std::string_view library) { return text.find(library) != std::string_view::npos; });
}

/// Whether `holds` is true of a function that is being called, as the loader knows it.
template <class Predicate>
bool any_caller(Predicate holds) {
  std::array<void*, kMostFrames> frames{};
  const int count = ::backtrace(frames.data(), kMostFrames);
  return std::any_of(frames.begin(), frames.begin() + count, [&](void* frame) {
    Dl_info about{};
    return ::dladdr(frame, &about) != 0 && about.dli_fname != nullptr && holds(about);
  });
}

/// Whether HDF5 has been given memory of ours to write to.
bool reads_into_ours() {
  return any_caller([](const Dl_info& about) {
    const std::string_view name = about.dli_sname != nullptr ? about.dli_sname : "";
    return is_of_hdf5(about.dli_fname) && (name == "H5Dread" || name == "H5Aread");
  });
}

/// Whether one of the innermost frames of the next stack in the report is HDF5's. Cuts the report after them.
bool in_hdf5(std::string_view& report) {
  constexpr int kInnermost = 4;  // the first may be memcpy's or malloc's
  for (int k = 0; k < kInnermost; ++k) {
    const std::size_t begin = report.find("    #");
    if (begin == std::string_view::npos) return false;
    const std::string_view line = report.substr(begin, report.find('\n', begin) - begin);
    report.remove_prefix(begin + line.size());
    if (is_of_hdf5(line)) return true;
  }
  return false;
}

/// A fault of the library is one in its code that is not about memory of ours. Which memory is next to where it has
/// strayed to says nothing if it has been given none.
bool is_fault_of_hdf5(std::string_view report) {
  if (!in_hdf5(report)) return false;
  const std::size_t allocated = report.find("allocated by thread");
  if (allocated == std::string_view::npos || !reads_into_ours()) return true;
  report.remove_prefix(allocated);
  return in_hdf5(report);
}

void on_report(const char* report) {
  if (is_fault_of_hdf5(report)) ::_exit(kFaultOfHdf5);
}

/// Time is over. Users are told so by try_in_child(). While a report is written there is all the time that it takes.
void on_alarm(int) {
  if (__asan_report_present() != 0) return;
  if (any_caller([](const Dl_info& about) { return is_of_hdf5(about.dli_fname); })) ::_exit(kHangInHdf5);
  std::abort();
}

void limit_time(int seconds) {
  const itimerval limit{.it_interval = {}, .it_value = {.tv_sec = seconds, .tv_usec = 0}};
  ::setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Memory of this process and its helpers.
void* shared(std::size_t bytes, void* at, int how) {
  void* const found = ::mmap(at, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | how, -1, 0);
  if (found == MAP_FAILED) std::abort();
  return found;
}

/// Whole pages only: what lies beside the counters is not to be shared.
void share_counters() {
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(counters_begin) + page - 1) / page * page;
  const std::uintptr_t end = reinterpret_cast<std::uintptr_t>(counters_end) / page * page;
  if (begin < end) shared(end - begin, reinterpret_cast<void*>(begin), MAP_FIXED);
}

class Helper {
 public:
  explicit Helper(const FuzzedReader& reader)
      : reader_(reader), input_(static_cast<char*>(shared(kMostBytes, nullptr, 0))) {
    share_counters();
  }

  /// How the helper ended: 0 if it has not, and waits for more.
  int read(std::string_view bytes) {
    if (child_ < 0 || served_ == kInputsPerHelper) start();
    ++served_;
    std::memcpy(input_, bytes.data(), bytes.size());
    const std::uint64_t size = bytes.size();
    std::uint64_t answer = 0;
    const bool answered = ::send(channel_, &size, sizeof size, MSG_NOSIGNAL) == sizeof size &&
                          ::recv(channel_, &answer, sizeof answer, MSG_WAITALL) == sizeof answer;
    return answered ? 0 : end();
  }

  [[nodiscard]] bool is_new() const noexcept { return served_ <= 1; }

  /// The next input is the first of a new one.
  void retire() {
    if (child_ >= 0) end();
  }

 private:
  void start() {
    retire();
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) std::abort();
    child_ = ::fork();
    if (child_ < 0) std::abort();
    if (child_ == 0) {
      ::close(ends[0]);
      serve(ends[1]);
    }
    ::close(ends[1]);
    channel_ = ends[0];
    served_ = 0;
  }

  [[noreturn]] void serve(int channel) {
    __sanitizer_set_death_callback([] {});  // libFuzzer's would keep the input
    __asan_set_error_report_callback(on_report);
    for (const int number : {SIGABRT, SIGALRM}) std::signal(number, SIG_DFL);
    std::signal(SIGPROF, on_alarm);
    H5set_free_list_limits(-1, -1, -1, -1, -1, -1);  // its large tables are used again, not mapped anew
    static_cast<void>(any_caller([](const Dl_info&) { return false; }));  // loads what it needs
    std::uint64_t size = 0;
    while (::recv(channel, &size, sizeof size, MSG_WAITALL) == sizeof size) {
      limit_time(kMostSeconds);
      reader_.read({input_, size});
      limit_time(0);
      if (::send(channel, &size, sizeof size, MSG_NOSIGNAL) != sizeof size) break;
    }
    ::_exit(0);
  }

  /// Waits for the end of the helper, which comes at once where its channel is closed.
  int end() {
    ::close(channel_);
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    return status;
  }

  const FuzzedReader& reader_;
  char* input_;
  pid_t child_ = -1;
  int channel_ = -1;
  int served_ = 0;
};

bool is_excused(int status) {
  return WIFEXITED(status) && (WEXITSTATUS(status) == kFaultOfHdf5 || WEXITSTATUS(status) == kHangInHdf5);
}

}  // namespace

void read_in_helper(const FuzzedReader& reader, std::string_view bytes) {
  static Helper helper(reader);
  if (bytes.size() > kMostBytes) return;
  int status = helper.read(bytes);
  if (status == 0 || is_excused(status)) return;
  const bool may_be_of_another = !helper.is_new();
  if (may_be_of_another) {
    helper.retire();
    status = helper.read(bytes);  // by itself
  }
  if (status != 0 && !is_excused(status)) std::abort();  // with the sanitizer's report above
  std::fprintf(stderr, "the report above is of memory that HDF5 spoiled with an earlier input\n");
}

}  // namespace carom::test

namespace carom::io {

/// Takes the place of the library's: all reading is done in a child here.
void try_in_child(const std::function<void()>&, const std::string&, double) {}

}  // namespace carom::io
