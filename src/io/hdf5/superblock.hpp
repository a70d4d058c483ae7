// The first bytes of an HDF5 file, as the format's specification lays them out (version 3 of the superblock).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace carom::io {

inline constexpr std::size_t kSuperblockSize = 48;
using Superblock = std::array<unsigned char, kSuperblockSize>;

/// Whether these bytes are a superblock that closed_superblock() understands.
bool is_superblock(const Superblock& block) noexcept;

/// Where the file ends according to its superblock.
std::uint64_t end_in(const Superblock& block) noexcept;

/// The same superblock, but of a file that nobody is writing to and that ends at `end`.
Superblock closed_superblock(Superblock block, std::uint64_t end) noexcept;

/// The checksum that HDF5 keeps of its metadata: Jenkins' lookup3 with the initial value 0 (Dr. Dobb's, 1997, and
/// burtleburtle.net/bob/c/lookup3.c).
std::uint32_t lookup3(const unsigned char* bytes, std::size_t count) noexcept;

}  // namespace carom::io
