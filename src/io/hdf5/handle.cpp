#include "handle.hpp"

#include <unistd.h>

#include <cassert>
#include <condition_variable>
#include <mutex>

#include "carom/base/error.hpp"

namespace carom::io {
namespace {

/// The reason that lies deepest in the library's stack: where it first went wrong.
std::string deepest_reason() {
  std::string reason;
  const auto take = [](unsigned, const H5E_error2_t* entry, void* into) -> herr_t {
    if (entry->desc != nullptr) *static_cast<std::string*>(into) = entry->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, take, &reason);
  return reason;
}

/// Who is in the library, and who waits to fork. Not a shared mutex: that of one process is no good in its copy.
struct Traffic {
  std::mutex mutex;  // guards what follows, and is held while forking
  std::condition_variable empty;
  std::condition_variable open;
  int inside = 0;           // threads in the library
  int waiting_to_fork = 0;  // threads; newcomers stay out meanwhile, or these might wait forever
};

Traffic& traffic() {
  static Traffic traffic;
  return traffic;
}

thread_local int times_inside = 0;

}  // namespace

InHdf5::InHdf5() noexcept {
  if (times_inside++ > 0) return;
  std::unique_lock lock(traffic().mutex);
  traffic().open.wait(lock, [] { return traffic().waiting_to_fork == 0; });
  ++traffic().inside;
}

InHdf5::~InHdf5() {
  if (--times_inside > 0) return;
  const std::lock_guard lock(traffic().mutex);
  if (--traffic().inside == 0 && traffic().waiting_to_fork > 0) traffic().empty.notify_all();
}

pid_t fork_outside_hdf5() noexcept {
  assert(times_inside == 0);
  std::unique_lock lock(traffic().mutex);
  ++traffic().waiting_to_fork;
  traffic().empty.wait(lock, [] { return traffic().inside == 0; });
  const pid_t child = ::fork();
  if (child == 0) {
    traffic().waiting_to_fork = 0;  // the others are not here
    return child;
  }
  if (--traffic().waiting_to_fork == 0) traffic().open.notify_all();
  return child;
}

void prepare_hdf5() {
  // Everything is closed by its Handle. When memory has failed it, the library's own cleaning up at exit may crash.
  static const herr_t no_cleaning = H5dont_atexit();
  static_cast<void>(no_cleaning);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);
}

void fail_hdf5(const std::string& file, std::string_view what) {
  std::string message(what);
  if (const std::string reason = deepest_reason(); !reason.empty()) message += " (HDF5: " + reason + ')';
  throw Error(message, {file});
}

Handle opened(hid_t id, Handle::Closer closer, const std::string& file, std::string_view what) {
  if (id < 0) fail_hdf5(file, what);
  return {id, closer};
}

}  // namespace carom::io
