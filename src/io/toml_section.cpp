#include "toml_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "carom/base/nearest_word.hpp"
#include "numbers.hpp"

namespace carom::io {
namespace {

std::string_view name_of_type(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "an array";
    case toml::node_type::string: return "a string";
    case toml::node_type::integer: return "a whole number";
    case toml::node_type::floating_point: return "a decimal number";
    case toml::node_type::boolean: return "a boolean";
    default: return "a date or time";
  }
}

/// Why a number may not have this value; empty if it may.
std::string_view fault_of(double value, Range range) {
  if (!std::isfinite(value)) return "must be a finite number";
  switch (range) {
    case Range::any: return {};
    case Range::positive: return value > 0 ? "" : "must be greater than 0";
    case Range::zero_or_more: return value >= 0 ? "" : "must be 0 or more";
    case Range::zero_to_one: return value >= 0 && value <= 1 ? "" : "must lie in [0, 1]";
  }
  return {};
}

}  // namespace

const toml::node* TomlSection::find(std::string_view key) {
  known_.push_back(key);
  return table_.get(key);
}

void TomlSection::complain(const toml::node& where, std::string message) {
  const toml::source_position& begin = where.source().begin;
  problems_.add(static_cast<int>(begin.line), static_cast<int>(begin.column), std::move(message));
}

std::optional<double> TomlSection::number_in(const toml::node& node, std::string_view key, Range range,
                                             std::string_view wanted) {
  double value = 0;
  if (const auto* real = node.as_floating_point()) {
    value = real->get();
  } else if (const auto* whole = node.as_integer()) {
    value = static_cast<double>(whole->get());
  } else {
    complain(node, fmt::format("{} must be {}, not {}", key, wanted, name_of_type(node)));
    return std::nullopt;
  }
  const std::string_view fault = fault_of(value, range);
  if (fault.empty()) return value;
  complain(node, fmt::format("{} is {}: it {}", key, value, fault));
  return std::nullopt;
}

std::optional<double> TomlSection::number(std::string_view key, Range range) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  return number_in(*node, key, range, "a number, e.g. 1.0");
}

std::optional<Vec2> TomlSection::two_numbers(std::string_view key, Range range) {
  constexpr std::string_view kWanted = "two numbers, e.g. [1.0, 2.0]";
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    complain(*node, fmt::format("{} must be {}, not {}", key, kWanted, name_of_type(*node)));
    return std::nullopt;
  }
  if (array->size() != 2) {
    complain(*node, fmt::format("{} must be {}, not {}", key, kWanted, array->size()));
    return std::nullopt;
  }
  const std::optional<double> x = number_in((*array)[0], key, range, kWanted);
  const std::optional<double> y = number_in((*array)[1], key, range, kWanted);
  if (!x || !y) return std::nullopt;
  return Vec2{*x, *y};
}

std::optional<std::uint64_t> TomlSection::count(std::string_view key, std::uint64_t least) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const auto* whole = node->as_integer();
  if (whole == nullptr) {
    complain(*node, fmt::format("{} must be a whole number, e.g. 1000, not {}", key, name_of_type(*node)));
    return std::nullopt;
  }
  if (whole->get() >= 0 && static_cast<std::uint64_t>(whole->get()) >= least) {
    return static_cast<std::uint64_t>(whole->get());
  }
  complain(*node, fmt::format("{} is {}: it must be {} or more", key, whole->get(), least));
  return std::nullopt;
}

std::optional<std::uint64_t> TomlSection::seed(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr || !node->is_string()) return count(key, 0);
  const std::optional<std::uint64_t> value = parse_count(*node->value_exact<std::string_view>());
  if (!value) complain(*node, fmt::format("{} must be a whole number below 2^64", key));
  return value;
}

std::optional<std::string> TomlSection::text(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const std::optional<std::string> value = node->value_exact<std::string>();
  if (!value) complain(*node, fmt::format("{} must be a string, not {}", key, name_of_type(*node)));
  return value;
}

const toml::table* TomlSection::table(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return nullptr;
  if (!node->is_table()) complain(*node, fmt::format("{0} must be a table: write [{0}]", key));
  return node->as_table();
}

std::vector<const toml::table*> TomlSection::tables(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    complain(*node, fmt::format("{0} must be written [[{0}]]: there can be several", key));
    return {};
  }
  std::vector<const toml::table*> found;
  for (const toml::node& entry : *array) {
    if (entry.is_table()) {
      found.push_back(entry.as_table());
    } else {
      complain(entry, fmt::format("every {} must be a table, not {}", key, name_of_type(entry)));
    }
  }
  return found;
}

void TomlSection::complain_of_name(const toml::node& node, std::string_view key,
                                   const std::vector<std::string_view>& names) {
  const std::string choices = fmt::format("\"{}\"", fmt::join(names, "\", \""));
  const std::optional<std::string_view> text = node.value_exact<std::string_view>();
  if (text) {
    complain(node, fmt::format("{} is \"{}\": it must be one of {}", key, *text, choices));
  } else {
    complain(node, fmt::format("{} must be one of {}, not {}", key, choices, name_of_type(node)));
  }
}

void TomlSection::refuse_other_keys() {
  for (const auto& [key, value] : table_) {
    const std::string_view name = key.str();
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    const std::string_view meant = nearest_word(name, known_);
    const bool is_section = value.is_table() || value.is_array_of_tables();
    std::string message = fmt::format("unknown {} '{}'", is_section ? "table" : "key", name);
    if (!title_.empty()) message += fmt::format(" in {}", title_);
    message += meant.empty() ? fmt::format(": the known ones are {}", fmt::join(known_, ", "))
                             : fmt::format(": did you mean '{}'?", meant);
    const toml::source_position& begin = key.source().begin;
    problems_.add(static_cast<int>(begin.line), static_cast<int>(begin.column), std::move(message));
  }
}

}  // namespace carom::io
