// HDF5 is not made for damaged files: it may crash on them, or never come back.
#pragma once

#include <functional>
#include <string>

namespace carom::io {

/// Does `reading` in a child process first, a copy of this one, and returns if that came to its end, be it with an
/// exception. Throws Error for `file` if the child crashed or took longer than `seconds`: then the same reading would
/// do so here.
void try_in_child(const std::function<void()>& reading, const std::string& file, double seconds);

}  // namespace carom::io
