// The one family of errors that the library throws.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace carom {

/// Where something was read: a file (or "<stdin>"), and line and column counted from 1.
/// Line 0 means the whole file; an empty file name means no file at all.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "file:line:column", "file:line", "file" or "", as far as the place is known.
std::string to_string(const Place& place);

/// One thing that is wrong: what and why, and where it was read if it came from a file.
struct Problem {
  std::string message;
  Place place;
};

/// "file:line:column: message", or the message alone where there is no place.
std::string to_string(const Problem& problem);

/// Thrown for bad input and failing files, never for a programming error. what() has a line per problem.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message, Place place = {});
  /// All problems of one input at once; the caller guarantees at least one.
  explicit Error(std::vector<Problem> problems);

  [[nodiscard]] const std::vector<Problem>& problems() const noexcept { return problems_; }

 private:
  std::vector<Problem> problems_;
};

}  // namespace carom
