#include "superblock.hpp"

#include <algorithm>
#include <bit>

namespace carom::io {
namespace {

constexpr std::array<unsigned char, 8> kSignature{0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kVersionAt = 8;
constexpr std::size_t kOffsetSizeAt = 9;
constexpr std::size_t kFlagsAt = 11;
constexpr std::size_t kEndAt = 28;
constexpr std::size_t kChecksumAt = 44;

void put(unsigned char* to, std::uint64_t value, std::size_t bytes) noexcept {
  for (std::size_t k = 0; k < bytes; ++k) to[k] = static_cast<unsigned char>(value >> (8 * k));
}

struct Words {
  std::uint32_t a, b, c;

  void add(const std::array<unsigned char, 12>& bytes) noexcept {
    const auto word = [&](std::size_t at) {
      std::uint32_t value = 0;
      for (std::size_t k = 4; k-- > 0;) value = value << 8 | bytes[at + k];
      return value;
    };
    a += word(0);
    b += word(4);
    c += word(8);
  }

  void mix() noexcept {
    const auto step = [](std::uint32_t& x, std::uint32_t y, std::uint32_t& z, int turn) {
      x -= z;
      x ^= std::rotl(z, turn);
      z += y;
    };
    step(a, b, c, 4);
    step(b, c, a, 6);
    step(c, a, b, 8);
    step(a, b, c, 16);
    step(b, c, a, 19);
    step(c, a, b, 4);
  }

  void finish() noexcept {
    const auto step = [](std::uint32_t& x, std::uint32_t y, int turn) {
      x ^= y;
      x -= std::rotl(y, turn);
    };
    step(c, b, 14);
    step(a, c, 11);
    step(b, a, 25);
    step(c, b, 16);
    step(a, c, 4);
    step(b, a, 14);
    step(c, b, 24);
  }
};

}  // namespace

bool is_superblock(const Superblock& block) noexcept {
  return std::equal(kSignature.begin(), kSignature.end(), block.begin()) && block[kVersionAt] == 3 &&
         block[kOffsetSizeAt] == 8 && block[kOffsetSizeAt + 1] == 8;
}

std::uint64_t end_in(const Superblock& block) noexcept {
  std::uint64_t end = 0;
  for (std::size_t k = 8; k-- > 0;) end = end << 8 | block[kEndAt + k];
  return end;
}

Superblock closed_superblock(Superblock block, std::uint64_t end) noexcept {
  block[kFlagsAt] = 0;
  put(block.data() + kEndAt, end, 8);
  put(block.data() + kChecksumAt, lookup3(block.data(), kChecksumAt), 4);
  return block;
}

std::uint32_t lookup3(const unsigned char* bytes, std::size_t count) noexcept {
  const auto start = static_cast<std::uint32_t>(0xdeadbeef + count);
  Words words{start, start, start};
  while (count > 12) {
    std::array<unsigned char, 12> block{};
    std::copy_n(bytes, block.size(), block.begin());
    words.add(block);
    words.mix();
    bytes += block.size();
    count -= block.size();
  }
  if (count == 0) return words.c;
  std::array<unsigned char, 12> last{};
  std::copy_n(bytes, count, last.begin());
  words.add(last);
  words.finish();
  return words.c;
}

}  // namespace carom::io
