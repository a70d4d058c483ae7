// HDF5 files in memory.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "handle.hpp"

namespace carom::io {

/// A new file in memory, to be read with image_of(). `name` is what messages call it; `expected` is about how many
/// bytes it will have.
Handle create_image(const std::string& name, std::size_t expected);
std::string image_of(const Handle& file, const std::string& name);

/// A file that lies in memory as it would on a disk, for reading. Copies the bytes.
Handle open_image(std::string_view bytes, const std::string& name);

}  // namespace carom::io
