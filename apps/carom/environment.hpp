// Environment variables that the program reads.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "carom/base/simd.hpp"

namespace carom::program {

/// The instruction set that CAROM_SIMD names; nothing where it is unset or empty. Throws UsageError for a name that
/// there is not, and Error for instructions that this processor lacks.
std::optional<Simd> simd_from_environment();

/// Adds what CAROM_SIMD does to the help of a command that heeds it.
void mention_simd_variable(CLI::App& command);

}  // namespace carom::program
