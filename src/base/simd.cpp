#include "carom/base/simd.hpp"

#include <array>
#include <string>

#include "carom/base/error.hpp"

#if defined(__x86_64__)
#define HWY_COMPILE_ALL_ATTAINABLE  // as where the hot loops are compiled: HWY_TARGETS are the same there
#include <hwy/targets.h>
#endif

namespace carom {
namespace {

constexpr std::array kAll{Simd::scalar, Simd::sse4, Simd::avx2, Simd::avx512};

#if defined(__x86_64__)

/// What of Highway's targets it takes.
constexpr std::int64_t target_of(Simd simd) noexcept {
  switch (simd) {
    case Simd::scalar: return 0;
    case Simd::sse4: return HWY_SSE4;
    case Simd::avx2: return HWY_AVX2;
    case Simd::avx512: return HWY_AVX3;
  }
  return 0;
}

bool is_available(Simd simd) noexcept {
  static const std::int64_t targets = HWY_TARGETS & hwy::SupportedTargets();  // asking takes some 10 µs
  return (targets & target_of(simd)) == target_of(simd);
}

#else

bool is_available(Simd simd) noexcept { return simd == Simd::scalar; }

#endif

std::string without_hyphens_in_lower_case(std::string_view name) {
  std::string plain;
  for (const char letter : name) {
    if (letter == '-') continue;
    plain.push_back(letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter);
  }
  return plain;
}

}  // namespace

std::string_view name_of(Simd simd) noexcept {
  switch (simd) {
    case Simd::scalar: return "scalar";
    case Simd::sse4: return "SSE4";
    case Simd::avx2: return "AVX2";
    case Simd::avx512: return "AVX-512";
  }
  return "";
}

std::optional<Simd> simd_named(std::string_view name) {
  for (const Simd simd : kAll) {
    if (without_hyphens_in_lower_case(name) == without_hyphens_in_lower_case(name_of(simd))) return simd;
  }
  return std::nullopt;
}

std::vector<Simd> available_simd() {
  std::vector<Simd> available;
  for (const Simd simd : kAll) {
    if (is_available(simd)) available.push_back(simd);
  }
  return available;
}

Simd fastest_simd() noexcept {
  Simd fastest = Simd::scalar;
  for (const Simd simd : kAll) {
    if (is_available(simd)) fastest = simd;
  }
  return fastest;
}

Simd usable_simd(std::optional<Simd> wanted) {
  if (!wanted) return fastest_simd();
  if (is_available(*wanted)) return *wanted;
  throw Error("this computer has no " + std::string(name_of(*wanted)) + " instructions: the best it has is " +
              std::string(name_of(fastest_simd())));
}

}  // namespace carom
