#include "handle.hpp"

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

}  // namespace

void prepare_hdf5() {
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
