// Problems as they are found in one file, and in the end as a reader wants them: in order, and not too many.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "carom/base/error.hpp"

namespace carom::io {

class ProblemList {
 public:
  /// At most `most` problems are kept in full, the rest as a number.
  ProblemList(std::string file, std::size_t most) : file_(std::move(file)), most_(most) {}

  [[nodiscard]] Place at(int line, int column = 0) const { return {file_, line, column}; }
  void add(int line, int column, std::string message);
  [[nodiscard]] std::size_t size() const noexcept { return found_; }
  /// Whether what comes is only counted: its words and place do not matter.
  [[nodiscard]] bool full() const noexcept { return found_ >= most_; }
  [[nodiscard]] bool empty() const noexcept { return found_ == 0; }

  /// In the order of the file; the last one may say how many more there are.
  [[nodiscard]] std::vector<Problem> in_order() const;
  /// Throws Error if there is any problem.
  void throw_if_any() const;

 private:
  std::string file_;
  std::size_t most_;
  std::size_t found_ = 0;
  std::vector<Problem> problems_;
};

}  // namespace carom::io
