// Trajectories in H5MD 1.1 (de Buyl, Colberg and Höfling, Comput. Phys. Commun. 185, 1546 (2014)). docs/files.md tells
// what stands where.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "carom/io/trajectory.hpp"

namespace carom::io {

std::unique_ptr<TrajectoryWriter> create_h5md(const std::string& path, const System& system);
std::unique_ptr<TrajectoryWriter> continue_h5md(const std::string& path, const System& system,
                                                const TrajectoryLength& kept);
std::unique_ptr<TrajectoryReader> open_h5md(const std::string& path);

/// The same for a file in memory.
std::unique_ptr<TrajectoryReader> open_h5md_image(std::string_view bytes, const std::string& name);

}  // namespace carom::io
