// The events' loop for each set of vector instructions; Highway has this file compiled once for every one.
#include <hwy/detect_compiler_arch.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>

#include "kernel_scalar.hpp"
#include "loops.hpp"
#include "workspace.hpp"

#if HWY_ARCH_X86

#ifndef HWY_COMPILE_ALL_ATTAINABLE
#define HWY_COMPILE_ALL_ATTAINABLE
#endif
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "window/fast/events_vector.cpp"
#include <hwy/foreach_target.h>
// Highway's own headers come after it.
#include <hwy/highway.h>

#if HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
#include "kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace carom::fast::HWY_NAMESPACE {
using TargetKernel = VectorKernel;
}
HWY_AFTER_NAMESPACE();

#undef CAROM_TARGET
#undef CAROM_INLINE
#undef CAROM_NOINLINE
#undef CAROM_BEGIN
#undef CAROM_END
#define CAROM_TARGET HWY_NAMESPACE
#define CAROM_INLINE HWY_INLINE
#define CAROM_NOINLINE HWY_NOINLINE
#define CAROM_BEGIN HWY_BEFORE_NAMESPACE();
#define CAROM_END HWY_AFTER_NAMESPACE();
#include "events-inl.hpp"
#endif

#if HWY_ONCE
namespace carom::fast {

Loops vector_loops(Simd simd, Neighbourhood neighbourhood, bool one_kind) noexcept {
  switch (simd) {
#if HWY_TARGETS & HWY_SSE4
    case Simd::sse4: return N_SSE4::loops(neighbourhood, one_kind);
#endif
#if HWY_TARGETS & HWY_AVX2
    case Simd::avx2: return N_AVX2::loops(neighbourhood, one_kind);
#endif
#if HWY_TARGETS & HWY_AVX3
    case Simd::avx512: return N_AVX3::loops(neighbourhood, one_kind);
#endif
    default: return {};
  }
}

}  // namespace carom::fast
#endif

#else

namespace carom::fast {
Loops vector_loops(Simd /*simd*/, Neighbourhood /*neighbourhood*/, bool /*one_kind*/) noexcept { return {}; }
}  // namespace carom::fast

#endif
