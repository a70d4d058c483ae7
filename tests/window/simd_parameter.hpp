// Tests that run once for every instruction set, and say which ones the processor lacks.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "carom/base/simd.hpp"

namespace carom {

class ForEverySimd : public testing::TestWithParam<Simd> {
 protected:
  void SetUp() override {
    const std::vector<Simd> available = available_simd();
    if (std::find(available.begin(), available.end(), GetParam()) == available.end()) {
      GTEST_SKIP() << "this computer has no " << name_of(GetParam());
    }
  }
};

inline auto every_simd() { return testing::Values(Simd::scalar, Simd::sse4, Simd::avx2, Simd::avx512); }

/// A test's name takes letters and digits only.
inline std::string test_name_of(const testing::TestParamInfo<Simd>& test) {
  std::string letters(name_of(test.param));
  std::erase(letters, '-');
  return letters;
}

}  // namespace carom
