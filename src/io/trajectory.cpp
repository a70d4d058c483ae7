#include "carom/io/trajectory.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "carom/base/error.hpp"
#include "carom/io/file.hpp"
#include "carom/io/xyz.hpp"
#include "h5md.hpp"

namespace carom {
namespace {

class XyzWriter final : public TrajectoryWriter {
 public:
  XyzWriter(OutputStream stream, std::uint64_t frames) : stream_(std::move(stream)), frames_(frames) {}

  void append(const System& system, const Frame& frame) override {
    stream_.write(xyz_frame(system, frame));
    stream_.flush();
    ++frames_;
  }

  [[nodiscard]] TrajectoryLength length() const noexcept override { return {frames_, stream_.size()}; }

  void cut_to(const TrajectoryLength& length) override {
    stream_.cut_to(length.bytes);
    frames_ = length.frames;
  }

  void sync() override { stream_.sync(); }
  void close() override { stream_.close(); }

 private:
  OutputStream stream_;
  std::uint64_t frames_;
};

class XyzTrajectory final : public TrajectoryReader {
 public:
  explicit XyzTrajectory(const std::string& path) : reader_(path) { reader_.allow_cut_off(); }

  std::optional<Setup> next() override { return reader_.next(); }
  std::optional<FrameHeader> skip() override {
    const auto header = reader_.skip();
    if (!header) return std::nullopt;
    return FrameHeader{header->disks, header->time};
  }
  [[nodiscard]] bool cut_off() const noexcept override { return reader_.cut_off(); }

 private:
  XyzReader reader_;
};

}  // namespace

std::unique_ptr<TrajectoryWriter> create_trajectory(const std::string& path, TrajectoryFormat format,
                                                    const System& system) {
  if (format == TrajectoryFormat::h5md) return io::create_h5md(path, system);
  return std::make_unique<XyzWriter>(OutputStream(path), 0);
}

std::unique_ptr<TrajectoryWriter> continue_trajectory(const std::string& path, TrajectoryFormat format,
                                                      const System& system, const TrajectoryLength& kept) {
  if (format == TrajectoryFormat::h5md) return io::continue_h5md(path, system, kept);
  return std::make_unique<XyzWriter>(OutputStream(path, kept.bytes), kept.frames);
}

std::unique_ptr<TrajectoryReader> open_trajectory(const std::string& path) {
  if (is_hdf5_file(path)) return io::open_h5md(path);
  return std::make_unique<XyzTrajectory>(path);
}

bool is_hdf5_file(const std::string& path) {
  std::error_code unknown;
  if (path == "-" || !std::filesystem::is_regular_file(path, unknown)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string start(4, '\0');
  return file.read(start.data(), static_cast<std::streamsize>(start.size())) && start == "\x89HDF";
}

}  // namespace carom
