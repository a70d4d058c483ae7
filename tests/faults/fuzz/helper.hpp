// HDF5 is not made for damaged files: it crashes on some of them, and may not come back. What it reads is therefore
// read in another process, which goes on to the next input as long as it lives.
#pragma once

#include <string_view>

#include "readers.hpp"

namespace carom::test {

/// Lets a helper process read `bytes`. Faults of HDF5 itself, which users are kept from by carom::io's try_in_child(),
/// end the helper only, and the next input gets a new one. Any other end of it (a crash in our code, or in HDF5 because
/// we lied to it, a sanitizer's report) ends this process, too. What the helper covers counts as covered here.
void read_in_helper(const FuzzedReader& reader, std::string_view bytes);

}  // namespace carom::test
