// Property: a name leads to its instruction set, the sets of this computer are in order of speed with scalar first, and
// one that is not there is refused.
#include "carom/base/simd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "carom/base/error.hpp"

namespace carom {
namespace {

constexpr Simd kAll[] = {Simd::scalar, Simd::sse4, Simd::avx2, Simd::avx512};

TEST(Simd, IsFoundByItsName) {
  for (const Simd simd : kAll) EXPECT_EQ(simd_named(name_of(simd)), simd);
  EXPECT_EQ(simd_named("Scalar"), Simd::scalar);
  EXPECT_EQ(simd_named("sse4"), Simd::sse4);
  EXPECT_EQ(simd_named("avx-2"), Simd::avx2);
  EXPECT_EQ(simd_named("avx512"), Simd::avx512);
}

TEST(Simd, IsNotFoundByAnotherName) {
  for (const char* name : {"", "-", "avx", "avx 2", "avx22", "neon", "scalar "}) EXPECT_FALSE(simd_named(name)) << name;
}

TEST(Simd, OfThisComputerBeginsWithScalarAndIsInOrder) {
  const std::vector<Simd> available = available_simd();
  ASSERT_FALSE(available.empty());
  EXPECT_EQ(available.front(), Simd::scalar);
  EXPECT_EQ(available.back(), fastest_simd());
  EXPECT_EQ(std::adjacent_find(available.begin(), available.end(), std::greater_equal{}), available.end());
}

#if defined(__x86_64__)
TEST(Simd, IsWhatTheCompilerSeesOfTheProcessor) {
  const std::vector<Simd> available = available_simd();
  const auto has = [&](Simd simd) { return std::count(available.begin(), available.end(), simd) == 1; };
  // Highway's sets take more than their name says.
  const bool sse4 =
      __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
  const bool avx2 =
      sse4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
  EXPECT_EQ(has(Simd::sse4), sse4);
  EXPECT_EQ(has(Simd::avx2), avx2);
  EXPECT_EQ(has(Simd::avx512), avx512);
}
#endif

TEST(Simd, IsTheFastestUnlessAnotherIsWanted) {
  EXPECT_EQ(usable_simd(std::nullopt), fastest_simd());
  for (const Simd simd : available_simd()) EXPECT_EQ(usable_simd(simd), simd);
}

TEST(Simd, ThatIsNotThereIsRefusedByName) {
  const std::vector<Simd> available = available_simd();
  bool refused = false;
  for (const Simd simd : kAll) {
    if (std::count(available.begin(), available.end(), simd) == 1) continue;
    refused = true;
    try {
      usable_simd(simd);
      ADD_FAILURE() << name_of(simd);
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), "this computer has no " + std::string(name_of(simd)) +
                                  " instructions: the best it has is " + std::string(name_of(fastest_simd())));
    }
  }
  if (!refused) GTEST_SKIP() << "this computer has them all";
}

}  // namespace
}  // namespace carom
