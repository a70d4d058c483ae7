#include <fstream>
#include <iostream>
#include <sstream>
#include <utility>

#include "carom/base/error.hpp"
#include "carom/io/file.hpp"
#include "carom/io/xyz.hpp"
#include "scene_reading.hpp"
#include "xyz_frames.hpp"

namespace carom {
namespace {

/// The last frame of a stream that can be set back.
io::XyzFrame last_frame(std::istream& input, const std::string& name) {
  io::XyzFrames frames(input, name);
  std::streampos begin = input.tellg();
  std::streampos begin_of_last = begin;
  int line_of_last = 1;
  while (const auto skipped = frames.skip()) {
    begin_of_last = begin;
    line_of_last = skipped->line;
    begin = input.tellg();
  }
  input.clear();
  input.seekg(begin_of_last);
  frames.restart_at(line_of_last);
  std::optional<io::XyzFrame> frame = frames.next();
  if (!frame) throw Error("there is no frame in this file", {name});
  return std::move(*frame);
}

}  // namespace

/// A stream of frames: a file's, or the standard input's.
class XyzReader::Source {
 public:
  explicit Source(const std::string& path) : frames_(path == "-" ? std::cin : file_, display_name(path)) {
    if (path == "-") return;
    // What cannot be read is refused with the system's reason, before the stream hides it.
    file_.open(path, std::ios::binary);
    if (!file_ || file_.peek() == std::ifstream::traits_type::eof()) read_file(path);
    file_.clear();
  }

  io::XyzFrames& frames() noexcept { return frames_; }

 private:
  std::ifstream file_;
  io::XyzFrames frames_;
};

XyzReader::XyzReader(const std::string& path) : source_(std::make_unique<Source>(path)) {}
XyzReader::~XyzReader() = default;
XyzReader::XyzReader(XyzReader&&) noexcept = default;
XyzReader& XyzReader::operator=(XyzReader&&) noexcept = default;

std::optional<Setup> XyzReader::next() {
  std::optional<io::XyzFrame> frame = source_->frames().next();
  if (!frame) return std::nullopt;
  return std::move(frame->setup);
}

void XyzReader::allow_cut_off() { source_->frames().allow_cut_off(); }
bool XyzReader::cut_off() const noexcept { return source_->frames().cut_off(); }

std::optional<XyzReader::Header> XyzReader::skip() {
  const auto skipped = source_->frames().skip();
  if (!skipped) return std::nullopt;
  return Header{skipped->disks, skipped->time};
}

Setup read_last_frame(const std::string& path) {
  std::istringstream input(read_file(path));
  return last_frame(input, display_name(path)).setup;
}

io::ReadScene io::read_xyz(std::string_view text, const std::string& name) {
  ReadScene read;
  try {
    std::istringstream input{std::string(text)};
    XyzFrame frame = last_frame(input, name);
    Scene& scene = read.file.scene;
    scene = explicit_scene(frame.setup);
    for (std::size_t k = 0; k < scene.disks.size(); ++k) scene.disks[k].place = {name, frame.lines[k], 1};
    scene.box_place = scene.physics_place = {name, frame.lines.empty() ? 0 : 2, 1};
  } catch (const Error& error) {
    read.understood = false;
    read.problems = error.problems();
  }
  return read;
}

}  // namespace carom
