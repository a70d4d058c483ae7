#include "carom/io/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "carom/base/error.hpp"

namespace carom {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;  // bytes read or written at once

[[noreturn]] void fail(const std::string& path, std::string_view what) {
  const std::string reason = std::generic_category().message(errno);
  throw Error(std::string(what) + ": " + reason, {path});
}

/// An open file; closed when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const noexcept { return number_; }
  /// Returns false with errno set if the system reports a late failure to write.
  [[nodiscard]] bool close() noexcept { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

bool write_all(int descriptor, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string read_all(int descriptor, const std::string& name) {
  std::string text;
  struct stat about {};
  if (::fstat(descriptor, &about) != 0) fail(name, "cannot be read");
  if (S_ISDIR(about.st_mode)) throw Error("cannot be read: it is a directory", {name});
  std::size_t size = 0;
  text.resize(static_cast<std::size_t>(about.st_size) + 1);
  while (true) {
    const ssize_t got = ::read(descriptor, text.data() + size, text.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(name, "cannot be read");
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
    if (size == text.size()) text.resize(size + std::max(size, kPiece));
  }
  text.resize(size);
  return text;
}

/// Writes to the file itself: for pipes and devices, which cannot be replaced.
void write_directly(const std::string& path, std::string_view text) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.number() < 0) fail(path, "cannot be written");
  if (!write_all(file.number(), text) || !file.close()) fail(path, "cannot be written");
}

/// A new file beside the one to be replaced; removed again unless it takes that one's place.
class Replacement {
 public:
  explicit Replacement(std::string target) : target_(std::move(target)) {
    static std::atomic<unsigned> count{0};
    do {
      path_ = target_ + ".new-" + std::to_string(::getpid()) + '-' + std::to_string(count++);
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
  }
  ~Replacement() {
    if (descriptor_ >= 0 && !in_place_) ::unlink(path_.c_str());
  }
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  /// False with errno set if it cannot take the target's place, which then stays as it was. The old file is kept as
  /// `previous` unless that is empty.
  [[nodiscard]] bool take_place(std::string_view text, const struct stat* old, const std::string& previous) {
    if (descriptor_ < 0) return false;
    Descriptor file(descriptor_);
    if (old != nullptr && ::fchmod(file.number(), old->st_mode & 0777) != 0) return false;
    if (!write_all(file.number(), text) || ::fsync(file.number()) != 0 || !file.close()) return false;
    if (old != nullptr && !previous.empty() && ::rename(target_.c_str(), previous.c_str()) != 0) return false;
    in_place_ = ::rename(path_.c_str(), target_.c_str()) == 0;
    if (!in_place_ && old != nullptr && !previous.empty()) take_back(previous);
    return in_place_ && sync_directory();
  }

 private:
  void take_back(const std::string& previous) const noexcept {
    const int reason = errno;
    ::rename(previous.c_str(), target_.c_str());
    errno = reason;
  }

  /// So that the new name is on the disk, too. File systems that cannot do it are taken at their word.
  [[nodiscard]] bool sync_directory() const {
    const std::string directory = std::filesystem::path(target_).parent_path().string();
    const Descriptor entry(::open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return entry.number() < 0 || ::fsync(entry.number()) == 0 || errno == EINVAL;
  }

  std::string target_;
  std::string path_;
  int descriptor_ = -1;
  bool in_place_ = false;
};

}  // namespace

std::string display_name(const std::string& path) { return path == "-" ? "<stdin>" : path; }

std::string read_file(const std::string& path) {
  if (path == "-") return read_all(STDIN_FILENO, display_name(path));
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) fail(path, "cannot be read");
  return read_all(file.number(), path);
}

void write_file(const std::string& path, std::string_view text) { write_file(path, text, {}); }

void write_file(const std::string& path, std::string_view text, const std::string& previous) {
  struct stat old {};
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (exists && !S_ISREG(old.st_mode)) return write_directly(path, text);
  std::error_code fault;
  const std::filesystem::path followed = std::filesystem::canonical(path, fault);  // through links to the file itself
  if (exists && fault) throw Error("cannot be written: " + fault.message(), {path});
  Replacement replacement(exists ? followed.string() : path);
  if (!replacement.take_place(text, exists ? &old : nullptr, previous)) fail(path, "cannot be written");
}

void prove_appendable(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) == 0 && !S_ISREG(about.st_mode)) return;  // who reads a pipe would see it end here
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
  if (file.number() < 0) fail(path, "cannot be written");
}

OutputStream::OutputStream(std::string path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path_, "cannot be written");
}

OutputStream::OutputStream(std::string path, std::uint64_t kept) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail(path_, "cannot be written");
  try {
    struct stat about {};
    if (::fstat(descriptor_, &about) != 0) fail(path_, "cannot be read");
    if (static_cast<std::uint64_t>(about.st_size) < kept) {
      throw Error("is shorter than it was: " + std::to_string(about.st_size) + " bytes, of which " +
                      std::to_string(kept) + " should stay",
                  {path_});
    }
    size_ = static_cast<std::uint64_t>(about.st_size);
    if (::lseek(descriptor_, 0, SEEK_END) < 0) fail(path_, "cannot be written");
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

OutputStream::OutputStream(OutputStream&& other) noexcept
    : path_(std::move(other.path_)),
      waiting_(std::move(other.waiting_)),
      size_(other.size_),
      descriptor_(std::exchange(other.descriptor_, -1)) {
  other.waiting_.clear();
}

OutputStream::~OutputStream() {
  if (descriptor_ < 0) return;
  write_all(descriptor_, waiting_);
  ::close(descriptor_);
}

void OutputStream::write(std::string_view bytes) {
  waiting_ += bytes;
  size_ += bytes.size();
  if (waiting_.size() >= kPiece) flush();
}

void OutputStream::flush() {
  const std::string bytes = std::exchange(waiting_, {});
  if (!write_all(descriptor_, bytes)) fail(path_, "cannot be written");
}

void OutputStream::cut_to(std::uint64_t size) {
  flush();
  const auto end = static_cast<off_t>(size);
  if (::ftruncate(descriptor_, end) != 0 || ::lseek(descriptor_, end, SEEK_SET) != end) {
    fail(path_, "cannot be written");
  }
  size_ = size;
}

void OutputStream::sync() {
  flush();
  if (::fdatasync(descriptor_) != 0 && errno != EINVAL) fail(path_, "cannot be written");  // pipes: EINVAL
}

void OutputStream::close() {
  if (descriptor_ < 0) return;
  flush();
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(path_, "cannot be written");
}

}  // namespace carom
