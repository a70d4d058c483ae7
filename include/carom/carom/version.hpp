// Which carom this is.
#pragma once

#include <string_view>

namespace carom {

/// "major.minor.patch".
std::string_view version() noexcept;

/// The compiler the library was built with, for instance "GCC 12.2.0".
std::string_view compiler() noexcept;

}  // namespace carom
