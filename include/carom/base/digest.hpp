// The fingerprint of a state: equal digests mean equal bits.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace carom {

/// XXH3 (64 bit) over the little-endian bytes of the numbers added, in the order they are added.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(Digest&&) noexcept;
  Digest& operator=(Digest&&) noexcept;

  void add(double value) noexcept;
  void add(std::int64_t value) noexcept;

  /// The digest of everything added so far.
  [[nodiscard]] std::uint64_t value() const noexcept;
  /// value() as 16 hexadecimal digits.
  [[nodiscard]] std::string hex() const;

 private:
  struct Hash;
  std::unique_ptr<Hash> hash_;
};

/// XXH3 (64 bit) of some bytes, as 16 hexadecimal digits.
std::string digest_of_bytes(std::string_view bytes);

}  // namespace carom
