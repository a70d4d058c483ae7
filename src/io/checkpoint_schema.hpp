// The part of a checkpoint that is an HDF5 file.
#pragma once

#include <string>
#include <string_view>

#include "carom/io/checkpoint.hpp"

namespace carom::io {

/// An HDF5 file in memory.
std::string checkpoint_image(const Checkpoint& checkpoint);

/// Reads such a file. Whether the bytes are those that were written is not asked here.
Checkpoint read_checkpoint_image(std::string_view image, const std::string& name);

}  // namespace carom::io
