// One table of a TOML file: hands out values by key and type, and knows in the end which keys nobody asked for.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
#include <version>

#define TOML_HEADER_ONLY 1
#ifdef __cpp_lib_to_chars
#define TOML_FLOAT_CHARCONV 1  // exact and without a stream for every number; toml++ avoids it for old compilers
#endif

namespace carom::io {
/// Thrown where toml++ would stop the program.
struct BrokenToml {};
[[noreturn]] inline void refuse_broken_toml() { throw BrokenToml(); }
}  // namespace carom::io

// Malformed text can break assertions of toml++ 3.3, which a build without assertions would pass over: both are wrong.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? static_cast<void>(0) : carom::io::refuse_broken_toml())
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include "carom/base/vec2.hpp"
#include "problem_list.hpp"

namespace carom::io {

/// What a number may be.
enum class Range { any, positive, zero_or_more, zero_to_one };

/// Every getter returns nothing if the key is absent, or if its value is wrong; then it has complained, with the place.
class TomlSection {
 public:
  /// `title` is what messages call the table: "[box]", "[[disk]]", or "" for the file's top.
  TomlSection(const toml::table& table, std::string_view title, ProblemList& problems)
      : table_(table), title_(title), problems_(problems), problems_before_(problems.size()) {}

  std::optional<double> number(std::string_view key, Range range = Range::any);
  std::optional<Vec2> two_numbers(std::string_view key, Range range = Range::any);
  std::optional<std::uint64_t> count(std::string_view key, std::uint64_t least);
  std::optional<std::string> text(std::string_view key);
  /// Any 64-bit number: above 2⁶³ − 1, where TOML's integers end, written as a string of digits.
  std::optional<std::uint64_t> seed(std::string_view key);

  template <typename Value>
  using Names = std::vector<std::pair<std::string_view, Value>>;
  template <typename Value>
  std::optional<Value> choice(std::string_view key, const Names<Value>& names) {
    const toml::node* node = find(key);
    return node == nullptr ? std::nullopt : named(*node, key, names);
  }
  /// One name for both axes, or a name for each.
  template <typename Value>
  std::optional<std::array<Value, 2>> choice_per_axis(std::string_view key, const Names<Value>& names);

  /// The table or the tables under a key.
  const toml::table* table(std::string_view key);
  std::vector<const toml::table*> tables(std::string_view key);

  /// The value of a key, or null.
  const toml::node* find(std::string_view key);
  void complain(const toml::node& where, std::string message);
  /// Complains about every key that no getter was asked for.
  void refuse_other_keys();
  /// Whether nothing was wrong with this table so far.
  [[nodiscard]] bool sound() const noexcept { return problems_.size() == problems_before_; }

 private:
  std::optional<double> number_in(const toml::node& node, std::string_view key, Range range, std::string_view wanted);
  template <typename Value>
  std::optional<Value> named(const toml::node& node, std::string_view key, const Names<Value>& names);
  void complain_of_name(const toml::node& node, std::string_view key, const std::vector<std::string_view>& names);

  const toml::table& table_;
  std::string_view title_;
  ProblemList& problems_;
  std::size_t problems_before_;
  std::vector<std::string_view> known_;
};

template <typename Value>
std::optional<Value> TomlSection::named(const toml::node& node, std::string_view key, const Names<Value>& names) {
  const std::optional<std::string_view> text = node.value_exact<std::string_view>();
  std::vector<std::string_view> all;
  for (const auto& [name, value] : names) {
    if (text == name) return value;
    all.push_back(name);
  }
  complain_of_name(node, key, all);
  return std::nullopt;
}

template <typename Value>
std::optional<std::array<Value, 2>> TomlSection::choice_per_axis(std::string_view key, const Names<Value>& names) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* array = node->as_array();
  const bool two = array != nullptr && array->size() == 2;
  if (array != nullptr && !two) {
    complain(*node, std::string(key) + " must be one name, or two: for x and for y");
    return std::nullopt;
  }
  const std::optional<Value> along_x = named(two ? (*array)[0] : *node, key, names);
  const std::optional<Value> along_y = two ? named((*array)[1], key, names) : along_x;
  if (!along_x || !along_y) return std::nullopt;
  return std::array{*along_x, *along_y};
}

}  // namespace carom::io
