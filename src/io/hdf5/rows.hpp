// A dataset that grows by one row at a time: a number, or an array with a compressed chunk for every 65536 entries.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "group.hpp"

namespace carom::io {

class Rows {
 public:
  /// A new dataset without rows. `row` are the extents of each; none for a single number.
  template <typename Number>
  static Rows create(const Group& group, const std::string& name, std::vector<hsize_t> row);
  /// One that create() has made. Throws Error if there is none with such rows.
  static Rows open(const Group& group, const std::string& name, std::vector<hsize_t> row);

  [[nodiscard]] hsize_t count() const noexcept { return count_; }
  /// Removes all rows from `count` on.
  void cut_to(hsize_t count);
  /// `row` has as many numbers as a row.
  template <typename Number>
  void append(std::span<const Number> row);
  /// Hands what was appended to the system.
  void flush();

 private:
  Rows(Handle data, std::vector<hsize_t> row, hsize_t count, std::string file);
  void write_number(const void* number, hid_t type);
  template <typename Number>
  void write_chunks(std::span<const Number> row);

  Handle data_;
  std::vector<hsize_t> row_;
  hsize_t count_;
  std::string file_;  // for messages
};

/// The bytes of `count` numbers of `size` bytes, first all lowest ones, then all second lowest …: HDF5's shuffle
/// filter.
std::vector<unsigned char> shuffled(const unsigned char* bytes, std::size_t size, std::size_t count);

}  // namespace carom::io
