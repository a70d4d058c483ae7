// An observable's partial sums, by name, so that a checkpoint can keep them and a resumed run goes on with the same
// bits.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "carom/base/error.hpp"

namespace carom {

/// Name → numbers. Names hold letters, digits, '_', '-', '.' and '/'.
using SavedSums = std::map<std::string, std::variant<std::vector<double>, std::vector<std::int64_t>>>;

/// Carries sums either into a SavedSums or out of one: an observable names each of its sums once, for both directions.
class SumsExchange {
 public:
  /// Saves into `saved`, or loads from it.
  enum class Direction { save, load };
  SumsExchange(SavedSums& saved, Direction direction) : saved_(&saved), direction_(direction) {}

  [[nodiscard]] bool loading() const noexcept { return direction_ == Direction::load; }

  /// The same below a name: sums of "pressure" are called "pressure/…".
  [[nodiscard]] SumsExchange below(std::string_view name) const {
    SumsExchange inner(*this);
    inner.prefix_ += std::string(name) + '/';
    return inner;
  }

  /// Throws Error when loading if there is no such entry, or one of another kind.
  void numbers(std::string_view name, std::vector<double>& values) { exchange(name, values); }
  void numbers(std::string_view name, std::vector<std::int64_t>& values) { exchange(name, values); }

  /// One number: double, bool or any integer of at most 64 bits.
  template <typename Number>
  void number(std::string_view name, Number& value) {
    static_assert(std::is_arithmetic_v<Number>);
    using Kept = std::conditional_t<std::is_floating_point_v<Number>, double, std::int64_t>;
    std::vector<Kept> one;
    if (!loading()) one.push_back(static_cast<Kept>(value));
    exchange(name, one);
    if (one.size() != 1) throw Error("sums are damaged: '" + prefix_ + std::string(name) + "' is not one number");
    if (loading()) value = static_cast<Number>(one.front());
  }

 private:
  template <typename Values>
  void exchange(std::string_view name, Values& values) {
    const std::string key = prefix_ + std::string(name);
    if (!loading()) {
      (*saved_)[key] = values;
      return;
    }
    const auto found = saved_->find(key);
    if (found == saved_->end()) throw Error("sums are incomplete: '" + key + "' is missing");
    const Values* const kept = std::get_if<Values>(&found->second);
    if (kept == nullptr) throw Error("sums are damaged: '" + key + "' has numbers of another kind");
    values = *kept;
  }

  SavedSums* saved_;
  Direction direction_;
  std::string prefix_;
};

}  // namespace carom
