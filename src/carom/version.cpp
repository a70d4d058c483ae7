#include "carom/carom/version.hpp"

namespace carom {

std::string_view version() noexcept { return CAROM_VERSION; }

std::string_view compiler() noexcept {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "an unknown compiler";
#endif
}

}  // namespace carom
