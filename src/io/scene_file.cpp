#include "carom/io/scene_file.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "carom/io/checkpoint.hpp"
#include "carom/io/file.hpp"
#include "carom/io/trajectory.hpp"
#include "h5md.hpp"
#include "numbers.hpp"
#include "scene_reading.hpp"
#include "words.hpp"

namespace carom {
namespace io {
namespace {

enum class SceneFormat { toml, algs4, xyz, h5md, checkpoint };

bool starts_with_a_count(std::string_view text) {
  std::vector<Word> words;
  while (!text.empty() && words.empty()) split_words(take_line(text), words);
  return words.size() == 1 && parse_count(words[0].text).has_value();
}

/// The second line of an extended XYZ file has key=value pairs, that of CollisionSystem's text has numbers.
SceneFormat format_of_counted_text(std::string_view text) {
  take_line(text);
  return take_line(text).find('=') == std::string_view::npos ? SceneFormat::algs4 : SceneFormat::xyz;
}

SceneFormat format_of(std::string_view text, std::string_view name) {
  if (text.starts_with("\x89HDF")) return SceneFormat::h5md;
  if (is_checkpoint(text)) return SceneFormat::checkpoint;
  if (name.ends_with(".toml")) return SceneFormat::toml;
  if (name.ends_with(".xyz") || name.ends_with(".extxyz")) return SceneFormat::xyz;
  return starts_with_a_count(text) ? format_of_counted_text(text) : SceneFormat::toml;
}

ReadScene nothing_read(const std::string& name, std::string message) {
  ReadScene read;
  read.understood = false;
  read.problems.push_back({std::move(message), {name}});
  return read;
}

/// The disks of a checkpoint, at time 0 of another run.
ReadScene read_state(Checkpoint checkpoint) {
  ReadScene read;
  read.file.scene = explicit_scene({std::move(checkpoint.snapshot.system), std::move(checkpoint.snapshot.state.disks)},
                                   std::move(checkpoint.title));
  return read;
}

/// The last frame of what `open` opens.
template <typename Open>
ReadScene read_last(const Open& open, const std::string& name) {
  const std::unique_ptr<TrajectoryReader> ahead = open();
  const std::unique_ptr<TrajectoryReader> reader = open();
  if (!ahead->skip()) return nothing_read(name, "there is no frame in this file");
  while (ahead->skip()) reader->skip();
  ReadScene read;
  read.file.scene = explicit_scene(reader->next().value());
  read.file.scene.box_place = read.file.scene.physics_place = {name, 0, 0};
  return read;
}

bool is_blank(std::string_view text) noexcept {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) != 0; });
}

}  // namespace

ReadScene read_any(std::string_view text, const std::string& name) {
  if (is_blank(text)) return nothing_read(name, "the file is empty");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
  const SceneFormat format = format_of(text, name);
  if (format == SceneFormat::checkpoint) return read_state(parse_checkpoint(text, name));
  if (format == SceneFormat::h5md) {
    return read_last([&] { return open_h5md_image(text, name); }, name);
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    ReadScene read = nothing_read(name, "this is not a text file: it has a NUL byte");
    read.problems[0].place.line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + nul, '\n'));
    return read;
  }
  if (format == SceneFormat::algs4) return read_algs4(text, name);
  return format == SceneFormat::xyz ? read_xyz(text, name) : read_toml(text, name);
}

ReadScene read_path(const std::string& path) {
  if (!is_hdf5_file(path)) return read_any(read_file(path), display_name(path));
  return read_last([&] { return open_h5md(path); }, path);  // may be larger than memory
}

}  // namespace io

namespace {

SceneFile sound(io::ReadScene read) {
  if (!read.problems.empty()) throw Error(std::move(read.problems));
  return std::move(read.file);
}

}  // namespace

SceneFile parse_scene(std::string_view text, const std::string& name) { return sound(io::read_any(text, name)); }

SceneFile read_scene(const std::string& path) { return sound(io::read_path(path)); }

std::vector<Problem> problems_in(const std::string& path,
                                 const std::function<std::vector<Problem>(const RunSettings&)>& more) {
  try {
    const io::ReadScene read = io::read_path(path);
    std::vector<Problem> problems = read.problems;
    const auto add = [&problems](const std::vector<Problem>& found) {
      problems.insert(problems.end(), found.begin(), found.end());
    };
    add(io::scene_problems(read));
    if (more && read.understood) add(more(read.file.run));
    return problems;
  } catch (const Error& error) {
    return error.problems();
  }
}

}  // namespace carom
