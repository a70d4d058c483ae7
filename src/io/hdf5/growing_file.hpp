// HDF5 files that grow while a run goes on and can be opened and read at any moment, also after the run was killed.
//
// The library writes them in its single-writer/multiple-reader mode, in which every single write leaves the file whole.
// Two things are added here, at the lowest level, where bytes go to the disk. The superblock on the disk always says
// that nobody is writing, and where the file ends, so that any reader takes it. And after a write that failed (a full
// disk) nothing more is written: the file stays as a crash at that moment would leave it, while the library, which does
// not survive such failures well, is told that all went well. failure() tells the truth.
#pragma once

#include <cstdint>
#include <string>

#include "handle.hpp"

namespace carom::io {

/// What the library writes to and reads from.
class GrowingFile {
 public:
  /// Creates a file that is to take the name `path` with put_in_place(), or opens the one that is there. Throws Error
  /// if that fails.
  enum class Start { create, go_on };
  GrowingFile(std::string path, Start start);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// The library's handle of this file, which must be closed before this object goes.
  [[nodiscard]] Handle open(Start start);

  /// Gives a created file its name, in place of what had it before.
  void put_in_place();
  /// Makes the superblock on the disk say where the file ends. To be called before metadata that refer to new data are
  /// written.
  void seal();
  /// When all is on the disk.
  void sync();
  /// From now on the library may tell itself where the file ends.
  void prepare_closing() noexcept { closing_ = true; }

  /// Throws Error with the path and the system's reason if anything could not be written.
  void throw_if_failed() const;

  // For the library.
  void write(std::uint64_t at, const unsigned char* bytes, std::size_t count) noexcept;
  [[nodiscard]] bool read(std::uint64_t at, unsigned char* bytes, std::size_t count) noexcept;
  void truncate() noexcept;
  void set_allocated(std::uint64_t end) noexcept { allocated_ = end; }
  [[nodiscard]] std::uint64_t allocated() const noexcept { return allocated_; }
  [[nodiscard]] std::uint64_t end() const noexcept { return end_; }

 private:
  void put(std::uint64_t at, const unsigned char* bytes, std::size_t count) noexcept;
  void resize(std::uint64_t end) noexcept;

  std::string path_;
  std::string new_path_;  // of a created file that is not in place yet
  int descriptor_ = -1;
  int failure_ = 0;  // the system's number of the first failure
  bool closing_ = false;
  std::uint64_t allocated_ = 0;  // up to here the library has given space away
  std::uint64_t end_ = 0;        // of the file
  std::uint64_t sealed_ = 0;     // where the superblock says that it ends
};

}  // namespace carom::io
