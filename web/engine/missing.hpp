// Included ahead of every file of the WebAssembly build: what the C++ library of Debian's Emscripten lacks.
#pragma once

#ifdef __cplusplus
#include <bit>
#include <type_traits>
#include <version>

#ifndef __cpp_lib_bit_cast
namespace std {
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}
}  // namespace std
#endif
#endif
