// What stands in for HDF5 in a build without it.
#include "carom/base/error.hpp"
#include "checkpoint_schema.hpp"
#include "h5md.hpp"

namespace carom::io {
namespace {

[[noreturn]] void refuse(const std::string& file) {
  throw Error("this carom was built without HDF5, which checkpoints and H5MD trajectories need", {file});
}

}  // namespace

std::string checkpoint_image(const Checkpoint&) { refuse("checkpoint"); }
Checkpoint read_checkpoint_image(std::string_view, const std::string& name) { refuse(name); }
std::unique_ptr<TrajectoryWriter> create_h5md(const std::string& path, const System&) { refuse(path); }
std::unique_ptr<TrajectoryWriter> continue_h5md(const std::string& path, const System&, const TrajectoryLength&) {
  refuse(path);
}
std::unique_ptr<TrajectoryReader> open_h5md(const std::string& path) { refuse(path); }
std::unique_ptr<TrajectoryReader> open_h5md_image(std::string_view, const std::string& name) { refuse(name); }

}  // namespace carom::io

bool carom::has_checkpoints() noexcept { return false; }
