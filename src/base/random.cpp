#include "carom/base/random.hpp"

#include <Random123/philox.h>

namespace carom {

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream, std::uint32_t purpose) noexcept
    : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
      counter_{0, static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32), purpose} {}

std::uint64_t RandomStream::bits() noexcept {
  if (left_ == 0) {
    const r123::Philox4x32::ctr_type counter{{counter_[0], counter_[1], counter_[2], counter_[3]}};
    const r123::Philox4x32::key_type key{{key_[0], key_[1]}};
    const auto word = r123::Philox4x32{}(counter, key);
    block_ = {std::uint64_t{word[1]} << 32 | word[0], std::uint64_t{word[3]} << 32 | word[2]};
    left_ = 2;
    ++counter_[0];
  }
  --left_;
  return block_[static_cast<std::size_t>(left_)];
}

double RandomStream::uniform() noexcept { return static_cast<double>(bits() >> 11) * 0x1p-53; }

std::uint64_t RandomStream::below(std::uint64_t bound) noexcept {
  const std::uint64_t remainder = (UINT64_MAX % bound + 1) % bound;  // 2^64 mod bound
  const std::uint64_t last_fair = UINT64_MAX - remainder;
  std::uint64_t draw = bits();
  while (draw > last_fair) draw = bits();
  return draw % bound;
}

// Von Neumann: the length of a falling run of uniforms that starts below 1/2 is even with probability e^(−1/2).
bool RandomStream::true_with_exp_minus_half() noexcept {
  double last = uniform();
  if (last >= 0.5) return true;
  for (bool even = false;; even = !even) {
    const double next = uniform();
    if (next >= last) return even;
    last = next;
  }
}

// Karney's Algorithm B: true with probability exp(−x (2k + x) / (2k + 2)).
bool RandomStream::accept_fraction(int k, double x) noexcept {
  const double ratio = (2 * k + x) / (2 * k + 2);
  double last = x;
  for (bool even = true;; even = !even) {
    const double next = uniform();
    if (next >= last || uniform() >= ratio) return even;
    last = next;
  }
}

double RandomStream::normal() noexcept {
  for (;;) {
    int k = 0;
    while (true_with_exp_minus_half()) ++k;
    bool accepted = true;
    for (int trial = 0; accepted && trial < k * (k - 1); ++trial) accepted = true_with_exp_minus_half();
    if (!accepted) continue;
    const double x = uniform();
    for (int trial = 0; accepted && trial <= k; ++trial) accepted = accept_fraction(k, x);
    if (!accepted) continue;
    return (bits() & 1) != 0 ? k + x : -(k + x);
  }
}

}  // namespace carom
