// Plots written to files.
#pragma once

#include <string>
#include <vector>

namespace carom::program {

/// Draws what a sweep found as SVG and PNG into DIRECTORY/plots; the names of the files. Nothing where carom is built
/// without pictures.
std::vector<std::string> draw_sweep(const std::string& directory);

}  // namespace carom::program
