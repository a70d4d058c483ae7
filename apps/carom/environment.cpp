#include "environment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "carom/base/error.hpp"
#include "command.hpp"

namespace carom::program {
namespace {

constexpr const char* kSimdVariable = "CAROM_SIMD";

std::vector<std::string_view> names_of(const std::vector<Simd>& sets) {
  std::vector<std::string_view> names;
  for (const Simd simd : sets) names.push_back(name_of(simd));
  return names;
}

}  // namespace

std::optional<Simd> simd_from_environment() {
  const char* const value = std::getenv(kSimdVariable);
  if (value == nullptr || *value == '\0') return std::nullopt;
  const std::optional<Simd> simd = simd_named(value);
  if (!simd) throw UsageError(fmt::format("{}: '{}' is not one of scalar, SSE4, AVX2, AVX-512", kSimdVariable, value));
  const std::vector<Simd> available = available_simd();
  if (std::find(available.begin(), available.end(), *simd) == available.end()) {
    throw Error(fmt::format("{}: this processor has no {}, only {}", kSimdVariable, name_of(*simd),
                            fmt::join(names_of(available), ", ")));
  }
  return simd;
}

void mention_simd_variable(CLI::App& command) {
  command.footer(command.get_footer() + fmt::format("\n\nEnvironment:\n"
                                                    "  {}=scalar|SSE4|AVX2|AVX-512 chooses the fast solver's "
                                                    "instructions; all give the same bits",
                                                    kSimdVariable));
}

}  // namespace carom::program
