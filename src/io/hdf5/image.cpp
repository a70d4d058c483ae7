#include "image.hpp"

#include <algorithm>

namespace carom::io {
namespace {

/// The library looks for a file of this name, and there cannot be one. It tells open files apart by their names, those
/// in memory too, and several runs may save at once: no two handles have the same number.
std::string no_file(const Handle& access) { return "/dev/null/in-memory-" + std::to_string(access.id()); }

constexpr std::size_t kLeastIncrement = std::size_t{1} << 16;

/// Access to files that live in memory only.
Handle memory_access(std::size_t increment, const std::string& name) {
  Handle access = opened(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, name, "HDF5 does not work");
  require(H5Pset_fapl_core(access.id(), std::max(increment, kLeastIncrement), false) >= 0, name, "HDF5 does not work");
  return access;
}

}  // namespace

Handle create_image(const std::string& name, std::size_t expected) {
  prepare_hdf5();
  const Handle access = memory_access(expected, name);
  return opened(H5Fcreate(no_file(access).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose, name,
                "cannot be written");
}

std::string image_of(const Handle& file, const std::string& name) {
  require(H5Fflush(file.id(), H5F_SCOPE_GLOBAL) >= 0, name, "cannot be written");
  const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
  require(size > 0, name, "cannot be written");
  std::string image(static_cast<std::size_t>(size), '\0');
  require(H5Fget_file_image(file.id(), image.data(), image.size()) == size, name, "cannot be written");
  return image;
}

Handle open_image(std::string_view bytes, const std::string& name) {
  prepare_hdf5();
  const Handle access = memory_access(0, name);
  std::string copy(bytes);  // the library asks for a pointer to what it may change, and copies it
  require(H5Pset_file_image(access.id(), copy.data(), copy.size()) >= 0, name, "cannot be read");
  return opened(H5Fopen(no_file(access).c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose, name,
                "is not a sound HDF5 file");
}

}  // namespace carom::io
