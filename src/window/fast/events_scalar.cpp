// The events' loop without vector instructions that the processor would have to be asked for.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>

#include "kernel_scalar.hpp"
#include "loops.hpp"
#include "workspace.hpp"
#ifdef __wasm_simd128__
#include "kernel_wasm.hpp"
#endif

namespace carom::fast::scalar {
#ifdef __wasm_simd128__
using TargetKernel = WasmKernel;
#else
using TargetKernel = ScalarKernel;
#endif
}  // namespace carom::fast::scalar

#define CAROM_TARGET scalar
#define CAROM_INLINE inline
#define CAROM_NOINLINE [[gnu::noinline]]
#define CAROM_BEGIN
#define CAROM_END
#include "events-inl.hpp"

namespace carom::fast {

Loops scalar_loops(Neighbourhood neighbourhood, bool one_kind) noexcept {
  return scalar::loops(neighbourhood, one_kind);
}

}  // namespace carom::fast
