// Objects of the HDF5 library, closed when they go out of scope, and its failures as Errors.
#pragma once

#include <hdf5.h>
#include <sys/types.h>

#include <string>
#include <string_view>
#include <utility>

namespace carom::io {

/// Lives as long as this thread is in the library, on its way in or out: whoever calls it has one. No process is forked
/// meanwhile, as the new one would wait forever for the locks of threads that it does not have.
class InHdf5 {
 public:
  InHdf5() noexcept;
  ~InHdf5();
  InHdf5(const InHdf5&) = delete;
  InHdf5& operator=(const InHdf5&) = delete;
};

/// fork() while no thread is in the library; the caller is not in it either. In the new process it can be used.
pid_t fork_outside_hdf5() noexcept;

/// An HDF5 identifier and what closes it.
class Handle {
 public:
  using Closer = herr_t (*)(hid_t);

  Handle() = default;
  Handle(hid_t id, Closer closer) noexcept : id_(id), closer_(closer) {}
  ~Handle() { close(); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), closer_(other.closer_) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      close();
      id_ = std::exchange(other.id_, H5I_INVALID_HID);
      closer_ = other.closer_;
    }
    return *this;
  }

  [[nodiscard]] hid_t id() const noexcept { return id_; }
  [[nodiscard]] bool open() const noexcept { return id_ >= 0; }
  /// False if the library reports a failure.
  bool close() noexcept {
    if (id_ < 0) return true;
    const InHdf5 inside;
    return closer_(std::exchange(id_, H5I_INVALID_HID)) >= 0;
  }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Closer closer_ = nullptr;
};

/// To be called before anything else of the library: it must neither print nor load plugins that a file names.
void prepare_hdf5();

/// Throws Error "what (the library's reason)" for `file`.
[[noreturn]] void fail_hdf5(const std::string& file, std::string_view what);

/// The object, or the Error of fail_hdf5() if there is none.
Handle opened(hid_t id, Handle::Closer closer, const std::string& file, std::string_view what);

inline void require(bool done, const std::string& file, std::string_view what) {
  if (!done) fail_hdf5(file, what);
}

}  // namespace carom::io
