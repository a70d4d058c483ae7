// The second line of an extended XYZ frame: key=value pairs, and the columns that follow.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/state/system.hpp"
#include "problem_list.hpp"

namespace carom::io {

/// In which words of a row a disk's numbers stand, counted from 0.
struct XyzColumns {
  std::size_t words = 0;  ///< in a row
  std::size_t position = 0;
  std::size_t position_words = 0;  ///< 2 or 3
  std::size_t velocity = 0;
  std::size_t velocity_words = 0;  ///< 2 or 3
  std::size_t radius = 0;
  std::optional<std::size_t> mass;
  std::optional<std::size_t> id;
};

struct XyzComment {
  double time = 0;
  Box box;
  Physics physics;
  XyzColumns columns;
};

/// Reads the comment on line `line`; adds to `problems` what is wrong with it.
XyzComment parse_xyz_comment(std::string_view text, int line, ProblemList& problems);

}  // namespace carom::io
