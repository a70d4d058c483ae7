// Which vector instructions the hot loops are compiled for, and which of them this processor has.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace carom {

/// Instruction sets, slowest first. All give the same bits.
enum class Simd { scalar, sse4, avx2, avx512 };

/// "scalar", "SSE4", "AVX2" or "AVX-512".
std::string_view name_of(Simd simd) noexcept;

/// The instruction set of this name, in any case and with or without the hyphen; nothing if there is none.
std::optional<Simd> simd_named(std::string_view name);

/// Those that this build was compiled for and this processor has, slowest first. Never empty.
std::vector<Simd> available_simd();

/// The last of available_simd().
Simd fastest_simd() noexcept;

/// `wanted`, or the fastest if nothing is wanted. Throws Error if `wanted` is not one of available_simd().
Simd usable_simd(std::optional<Simd> wanted);

}  // namespace carom
