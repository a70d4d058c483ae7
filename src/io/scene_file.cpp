#include "carom/io/scene_file.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "carom/io/file.hpp"
#include "numbers.hpp"
#include "scene_reading.hpp"
#include "words.hpp"

namespace carom {
namespace io {
namespace {

enum class SceneFormat { toml, algs4, xyz, hdf5 };

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
  if (text.starts_with("\x89HDF")) return SceneFormat::hdf5;
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

bool is_blank(std::string_view text) noexcept {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) != 0; });
}

}  // namespace

ReadScene read_any(std::string_view text, const std::string& name) {
  if (is_blank(text)) return nothing_read(name, "the file is empty");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
  if (const std::size_t nul = text.find('\0');
      nul != std::string_view::npos && format_of(text, name) != SceneFormat::hdf5) {
    ReadScene read = nothing_read(name, "this is not a text file: it has a NUL byte");
    read.problems[0].place.line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + nul, '\n'));
    return read;
  }
  switch (format_of(text, name)) {
    case SceneFormat::toml: return read_toml(text, name);
    case SceneFormat::algs4: return read_algs4(text, name);
    case SceneFormat::xyz: return read_xyz(text, name);
    case SceneFormat::hdf5: break;
  }
  return nothing_read(name, "this is an HDF5 file: scenes are read from TOML, extended XYZ or CollisionSystem text");
}

}  // namespace io

SceneFile parse_scene(std::string_view text, const std::string& name) {
  io::ReadScene read = io::read_any(text, name);
  if (!read.problems.empty()) throw Error(std::move(read.problems));
  return std::move(read.file);
}

SceneFile read_scene(const std::string& path) { return parse_scene(read_file(path), display_name(path)); }

std::vector<Problem> problems_in(const std::string& path) {
  try {
    const io::ReadScene read = io::read_any(read_file(path), display_name(path));
    std::vector<Problem> problems = read.problems;
    const std::vector<Problem> more = io::scene_problems(read);
    problems.insert(problems.end(), more.begin(), more.end());
    return problems;
  } catch (const Error& error) {
    return error.problems();
  }
}

}  // namespace carom
