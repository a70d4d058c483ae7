#include "growing_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <type_traits>

#include "carom/base/error.hpp"
#include "superblock.hpp"

namespace carom::io {
namespace {

/// Metadata that are made between a seal and the next find room up to here.
constexpr std::uint64_t kRoomForMetadata = std::uint64_t{1} << 16;

/// What the library keeps of an open file. Its own part comes first: it knows no other.
struct Driver {
  H5FD_t base;
  GrowingFile* file;
};
static_assert(std::is_standard_layout_v<Driver>);

GrowingFile& file_of(H5FD_t* driver) noexcept { return *reinterpret_cast<Driver*>(driver)->file; }
const GrowingFile& file_of(const H5FD_t* driver) noexcept { return *reinterpret_cast<const Driver*>(driver)->file; }

/// The access list carries a pointer to the file.
H5FD_t* open_driver(const char*, unsigned, hid_t access, haddr_t) {
  const void* const given = H5Pget_driver_info(access);
  if (given == nullptr) return nullptr;
  auto driver = new (std::nothrow) Driver{};
  if (driver != nullptr) driver->file = *static_cast<GrowingFile* const*>(given);
  return reinterpret_cast<H5FD_t*>(driver);
}

herr_t close_driver(H5FD_t* driver) {
  delete reinterpret_cast<Driver*>(driver);
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* features) {
  if (features != nullptr) *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_SUPPORTS_SWMR_IO;
  return 0;
}

herr_t write_driver(H5FD_t* driver, H5FD_mem_t, hid_t, haddr_t at, std::size_t count, const void* bytes) {
  file_of(driver).write(at, static_cast<const unsigned char*>(bytes), count);
  return 0;
}

herr_t read_driver(H5FD_t* driver, H5FD_mem_t, hid_t, haddr_t at, std::size_t count, void* bytes) {
  return file_of(driver).read(at, static_cast<unsigned char*>(bytes), count) ? 0 : -1;
}

herr_t truncate_driver(H5FD_t* driver, hid_t, hbool_t) {
  file_of(driver).truncate();
  return 0;
}

haddr_t allocated(const H5FD_t* driver, H5FD_mem_t) { return file_of(driver).allocated(); }

herr_t set_allocated(H5FD_t* driver, H5FD_mem_t, haddr_t end) {
  file_of(driver).set_allocated(end);
  return 0;
}

haddr_t end_of_file(const H5FD_t* driver, H5FD_mem_t) {
  return std::max<haddr_t>(file_of(driver).end(), file_of(driver).allocated());
}

hid_t register_driver() {
  static constexpr H5FD_mem_t kSeparate[] = H5FD_FLMAP_DICHOTOMY;
  static H5FD_class_t driver{};
  driver.name = "carom";
  driver.maxaddr = (haddr_t{1} << 62) - 1;
  driver.fc_degree = H5F_CLOSE_STRONG;
  driver.fapl_size = sizeof(GrowingFile*);
  driver.open = open_driver;
  driver.close = close_driver;
  driver.query = query;
  driver.get_eoa = allocated;
  driver.set_eoa = set_allocated;
  driver.get_eof = end_of_file;
  driver.read = read_driver;
  driver.write = write_driver;
  driver.truncate = truncate_driver;
  std::copy(std::begin(kSeparate), std::end(kSeparate), std::begin(driver.fl_map));
  return H5FDregister(&driver);
}

}  // namespace

GrowingFile::GrowingFile(std::string path, Start start) : path_(std::move(path)) {
  const bool create = start == Start::create;
  if (create) {
    new_path_ = path_ + ".new-" + std::to_string(::getpid());
    ::unlink(new_path_.c_str());  // of a process of this number that was killed
  }
  descriptor_ = create ? ::open(new_path_.c_str(), O_RDWR | O_CLOEXEC | O_CREAT | O_EXCL, 0666)
                       : ::open(path_.c_str(), O_RDWR | O_CLOEXEC);
  struct stat about {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &about) != 0) {
    const std::string reason = std::generic_category().message(errno);
    if (descriptor_ >= 0) ::close(descriptor_);
    throw Error("cannot be written: " + reason, {path_});
  }
  end_ = static_cast<std::uint64_t>(about.st_size);
}

GrowingFile::~GrowingFile() {
  if (!new_path_.empty()) ::unlink(new_path_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

Handle GrowingFile::open(Start start) {
  prepare_hdf5();
  static const hid_t driver = register_driver();
  GrowingFile* self = this;
  const Handle access = opened(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path_, "HDF5 does not work");
  require(H5Pset_driver(access.id(), driver, &self) >= 0 &&
              H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0,
          path_, "HDF5 does not work");
  const hid_t id = start == Start::create ? H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id())
                                          : H5Fopen(path_.c_str(), H5F_ACC_RDWR, access.id());
  throw_if_failed();
  return opened(id, H5Fclose, path_, "is not a sound HDF5 file");
}

void GrowingFile::throw_if_failed() const {
  if (failure_ != 0) throw Error("cannot be written: " + std::generic_category().message(failure_), {path_});
}

void GrowingFile::put(std::uint64_t at, const unsigned char* bytes, std::size_t count) noexcept {
  while (count > 0 && failure_ == 0) {
    const ssize_t written = ::pwrite(descriptor_, bytes, count, static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      failure_ = written < 0 ? errno : ENOSPC;
      return;
    }
    at += static_cast<std::uint64_t>(written);
    bytes += written;
    count -= static_cast<std::size_t>(written);
    end_ = std::max(end_, at);
  }
}

void GrowingFile::write(std::uint64_t at, const unsigned char* bytes, std::size_t count) noexcept {
  Superblock block{};
  if (at > 0 || count < block.size()) return put(at, bytes, count);
  std::copy_n(bytes, block.size(), block.begin());
  if (is_superblock(block)) {
    // At its end the library knows best, and cuts off what is beyond.
    sealed_ = closing_ ? end_in(block) : std::max(end_in(block), sealed_);
    if (!closing_) resize(std::max(end_, sealed_));
    block = closed_superblock(block, sealed_);
  }
  put(0, block.data(), block.size());
  put(block.size(), bytes + block.size(), count - block.size());
}

bool GrowingFile::read(std::uint64_t at, unsigned char* bytes, std::size_t count) noexcept {
  while (count > 0) {
    const ssize_t got = ::pread(descriptor_, bytes, count, static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return false;
    if (got == 0) {
      std::memset(bytes, 0, count);  // allocated and never written
      return true;
    }
    at += static_cast<std::uint64_t>(got);
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

void GrowingFile::resize(std::uint64_t end) noexcept {
  if (failure_ != 0 || end == end_) return;
  if (::ftruncate(descriptor_, static_cast<off_t>(end)) != 0) {
    failure_ = errno;
    return;
  }
  end_ = end;
}

void GrowingFile::truncate() noexcept {
  if (closing_) resize(allocated_);
}

void GrowingFile::put_in_place() {
  throw_if_failed();
  if (::rename(new_path_.c_str(), path_.c_str()) != 0) failure_ = errno;
  throw_if_failed();
  new_path_.clear();
}

void GrowingFile::seal() {
  Superblock block{};
  if (read(0, block.data(), block.size()) && is_superblock(block)) {
    sealed_ = std::max({sealed_, end_, allocated_ + kRoomForMetadata});
    resize(sealed_);
    block = closed_superblock(block, sealed_);
    put(0, block.data(), block.size());
  }
  throw_if_failed();
}

void GrowingFile::sync() {
  if (failure_ == 0 && ::fdatasync(descriptor_) != 0) failure_ = errno;
  throw_if_failed();
}

}  // namespace carom::io
