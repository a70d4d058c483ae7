// HDF5 is not made for damaged files: it may crash on them, or never come back.
#pragma once

#include <functional>
#include <string>

#include "carom/base/error.hpp"

namespace carom::io {

/// The file could not be tried to the end: it may be sound.
class NotTried : public Error {
 public:
  using Error::Error;
};

/// Does `reading` in a child process first, a copy of this one, and returns if that came to its end, be it with an
/// exception. Throws Error for `file` if the child crashed: then the same reading would do so here. Throws NotTried if
/// there could be no child, or it was killed or took longer than `seconds`.
void try_in_child(const std::function<void()>& reading, const std::string& file, double seconds);

}  // namespace carom::io
