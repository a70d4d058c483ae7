#include "carom/base/digest.hpp"

#include <array>
#include <bit>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace carom {
namespace {

std::string in_hexadecimal(std::uint64_t value) {
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[value >> shift & 15];
  return text;
}

}  // namespace

struct Digest::Hash {
  XXH3_state_t state;

  void add_bytes(std::uint64_t word) noexcept {
    std::array<unsigned char, 8> bytes;
    for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<unsigned char>(word >> (8 * k));
    XXH3_64bits_update(&state, bytes.data(), bytes.size());
  }
};

Digest::Digest() : hash_(std::make_unique<Hash>()) { XXH3_64bits_reset(&hash_->state); }
Digest::~Digest() = default;
Digest::Digest(Digest&&) noexcept = default;
Digest& Digest::operator=(Digest&&) noexcept = default;

void Digest::add(double value) noexcept { hash_->add_bytes(std::bit_cast<std::uint64_t>(value)); }
void Digest::add(std::int64_t value) noexcept { hash_->add_bytes(std::bit_cast<std::uint64_t>(value)); }

std::uint64_t Digest::value() const noexcept { return XXH3_64bits_digest(&hash_->state); }

std::string Digest::hex() const { return in_hexadecimal(value()); }

std::string digest_of_bytes(std::string_view bytes) { return in_hexadecimal(XXH3_64bits(bytes.data(), bytes.size())); }

}  // namespace carom
