// Text in and out of files, such that no failure goes unnoticed and no file is left half-written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace carom {

/// The name that messages use for a path: "<stdin>" for "-".
std::string display_name(const std::string& path);

/// All bytes of a file; "-" reads the standard input. Throws Error naming the file and the reason if it is missing,
/// a directory, or cannot be read. An empty file gives an empty text.
std::string read_file(const std::string& path);

/// Replaces a file by `text`, or leaves it as it was: writes a new file beside it, and renames that when every byte
/// is safe on disk. Pipes and devices (/dev/stdout) are written directly. A program should ignore SIGXFSZ and
/// SIGPIPE, so that a full quota or a closed pipe arrives here as an Error with the path and the system's reason.
void write_file(const std::string& path, std::string_view text);

/// The same, and what was there before is kept as `previous`, a name in the same directory. At every moment one of the
/// two is whole.
void write_file(const std::string& path, std::string_view text, const std::string& previous);

/// Throws Error if the file cannot be opened for writing. Creates it if it is not there, changes nothing in it.
void prove_appendable(const std::string& path);

/// A file that grows while a run goes on; bytes are gathered in memory and written in large pieces.
class OutputStream {
 public:
  /// Creates the file or empties it. Throws Error if that fails.
  explicit OutputStream(std::string path);
  /// Goes on with a file that has `kept` bytes or more, at its end. Throws Error if it has fewer.
  OutputStream(std::string path, std::uint64_t kept);
  /// Writes what is left but cannot report a failure: call close() before.
  ~OutputStream();
  OutputStream(OutputStream&& other) noexcept;
  OutputStream& operator=(OutputStream&&) = delete;

  /// These throw Error with the path and the reason if bytes cannot be written.
  void write(std::string_view bytes);
  void flush();
  /// Flushes, and returns when the bytes are safe on the disk.
  void sync();
  void close();
  /// Removes what was written after the file was this long.
  void cut_to(std::uint64_t size);

  /// How long the file is with all that was written, flushed or not.
  [[nodiscard]] std::uint64_t size() const noexcept { return size_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  std::string path_;
  std::string waiting_;  // bytes not yet handed to the system
  std::uint64_t size_ = 0;
  int descriptor_ = -1;
};

}  // namespace carom
