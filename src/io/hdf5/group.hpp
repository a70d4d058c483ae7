// Numbers and texts in a group of an HDF5 file: written little-endian, read with every size checked before memory is
// taken. Only what lies in the file itself is read: no links to other names or files, no data elsewhere.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "handle.hpp"

namespace carom::io {

/// What a reader is told of an array before it is read.
struct ArrayShape {
  std::vector<hsize_t> extents;
  bool integers = false;  ///< else floating-point numbers
  [[nodiscard]] hsize_t count() const noexcept;
};

class Group {
 public:
  /// The root of an open file; `name` is what messages call the file.
  Group(const Handle& file, std::string name);

  /// A group below this one, which must be there as a hard link; and one made new.
  [[nodiscard]] Group below(const std::string& path) const;
  [[nodiscard]] Group create(const std::string& name) const;
  /// Whether there is a hard link of this name, through hard links only.
  [[nodiscard]] bool has(const std::string& path) const;
  [[nodiscard]] bool has_attribute(const std::string& name) const;
  [[nodiscard]] bool is_group(const std::string& name) const;
  /// Names of all links, in order. Throws Error if there are more than `most`.
  [[nodiscard]] std::vector<std::string> names(std::size_t most) const;

  void write_text(const std::string& name, std::string_view text) const;
  void write_attribute(const std::string& name, double value) const;
  void write_attribute(const std::string& name, std::uint64_t value) const;
  void write_attribute(const std::string& name, const std::vector<double>& values) const;
  void write_attribute(const std::string& name, const std::vector<std::int64_t>& values) const;
  void write_attribute(const std::string& name, std::string_view text) const;
  void write_attribute(const std::string& name, const std::vector<std::string>& texts) const;

  template <typename Number>
  void write_array(const std::string& name, const std::vector<Number>& values) const;

  /// Throw Error naming what is missing, of another kind, or too large.
  [[nodiscard]] std::string read_text(const std::string& name, std::size_t most) const;
  [[nodiscard]] double read_number(const std::string& attribute) const;
  [[nodiscard]] std::uint64_t read_count(const std::string& attribute) const;
  [[nodiscard]] std::vector<double> read_numbers(const std::string& attribute, std::size_t count) const;
  [[nodiscard]] std::string read_text_attribute(const std::string& attribute) const;
  [[nodiscard]] std::vector<std::string> read_texts(const std::string& attribute, std::size_t most) const;

  /// A dataset that lies in this file, is no larger than `most` numbers, and is stored in a way that is known here.
  [[nodiscard]] Handle open_array(const std::string& path, ArrayShape& shape, double most) const;
  /// All numbers of a dataset with one extent. `count` must be its length.
  template <typename Number>
  [[nodiscard]] std::vector<Number> read_array(const std::string& path, std::size_t count) const;
  /// The length of a dataset with one extent.
  [[nodiscard]] std::size_t length_of(const std::string& path, double most) const;

  [[nodiscard]] hid_t id() const noexcept { return group_.id(); }
  [[nodiscard]] const std::string& file_name() const noexcept { return name_; }
  [[noreturn]] void fail(std::string_view what) const;

 private:
  Group(Handle group, std::string name, std::string path);
  [[nodiscard]] std::string described(std::string_view member) const;
  [[nodiscard]] Handle open_attribute(const std::string& name, ArrayShape& shape) const;

  Handle group_;
  std::string name_;
  std::string path_;  // of the group, for messages
};

/// The type of a number in a file.
template <typename Number>
hid_t file_type();
/// The same in memory.
template <typename Number>
hid_t memory_type();

}  // namespace carom::io
