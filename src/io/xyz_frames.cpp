#include "xyz_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "numbers.hpp"

namespace carom::io {
namespace {

constexpr std::size_t kMostProblems = 20;

}  // namespace

/// One disk as it stands in the file.
struct XyzFrames::Row {
  Vec2 position;
  Vec2 velocity;
  double z = 0;
  Species kind;
  double id = 0;
  int line = 0;
};

bool XyzFrames::next_line() {
  if (!std::getline(input_, text_)) {
    if (input_.bad()) throw Error("cannot be read to its end", {name_, line_, 0});
    ended_ = true;
    return false;
  }
  ended_ = input_.eof();
  ++line_;
  return true;
}

/// The number of disks of the next frame; nothing if only blank lines are left.
std::optional<std::size_t> XyzFrames::read_count() {
  do {
    if (!next_line()) return std::nullopt;
    split_words(text_, words_);
  } while (words_.empty());
  const std::optional<std::uint64_t> count = words_.size() == 1 ? parse_count(words_[0].text) : std::nullopt;
  if (!count) throw Error("here must stand the number of disks of a frame, alone", {name_, line_, words_[0].column});
  if (*count == 0) throw Error("the number of disks is 0: there must be at least one", {name_, line_, 1});
  return *count;
}

XyzComment XyzFrames::read_comment(ProblemList& problems) {
  if (!next_line()) throw Error("the file ends before the frame's comment line", {name_, line_, 0});
  return parse_xyz_comment(text_, line_, problems);
}

void XyzFrames::fail_cut_off(std::size_t found, std::size_t wanted) const {
  throw Error(fmt::format("the file ends after {} of {} disks", found, wanted), {name_, line_, 0});
}

double XyzFrames::read_number(std::size_t column, std::string_view what, ProblemList& problems) const {
  const Word& word = words_[column];
  const ParsedNumber number = parse_number(word.text);
  if (!number.fault.empty()) {
    problems.add(line_, word.column, fmt::format("{} '{}' {}", what, word.text, number.fault));
  }
  return number.value;
}

XyzFrames::Row XyzFrames::read_row(const XyzColumns& columns, ProblemList& problems) {
  Row row;
  row.line = line_;
  split_words(text_, words_);
  if (words_.size() != columns.words) {
    problems.add(line_, 1, fmt::format("{} columns: Properties says {}", words_.size(), columns.words));
    return row;
  }
  const auto number = [&](std::size_t column, std::string_view what) { return read_number(column, what, problems); };
  row.position = {number(columns.position, "x"), number(columns.position + 1, "y")};
  row.velocity = {number(columns.velocity, "vx"), number(columns.velocity + 1, "vy")};
  if (columns.position_words == 3) row.z = number(columns.position + 2, "z");
  if (columns.velocity_words == 3 && number(columns.velocity + 2, "vz") != 0) {
    problems.add(line_, words_[columns.velocity + 2].column, "vz is not 0: the disks move in a plane");
  }
  row.kind.radius = number(columns.radius, "radius");
  if (columns.mass) row.kind.mass = number(*columns.mass, "mass");
  if (columns.id) row.id = number(*columns.id, "id");
  return row;
}

/// Whatever is wrong with a frame in which the file ends, it may be that it was cut off there. Of the first frame it is
/// told what is wrong.
std::optional<XyzFrame> XyzFrames::next() {
  try {
    std::optional<XyzFrame> frame = read_frame();
    any_whole_ = true;
    return frame;
  } catch (const Error&) {
    cut_off_ = may_be_cut_off_ && any_whole_ && ended_;
    if (!cut_off_) throw;
    return std::nullopt;
  }
}

std::optional<XyzFrames::Skipped> XyzFrames::skip() {
  try {
    const std::optional<Skipped> skipped = skip_frame();
    any_whole_ = true;
    return skipped;
  } catch (const Error&) {
    cut_off_ = may_be_cut_off_ && any_whole_ && ended_;
    if (!cut_off_) throw;
    return std::nullopt;
  }
}

std::optional<XyzFrame> XyzFrames::read_frame() {
  const std::optional<std::size_t> count = read_count();
  if (!count) return std::nullopt;
  ProblemList problems(name_, kMostProblems);
  const XyzComment comment = read_comment(problems);
  problems.throw_if_any();

  std::vector<Row> rows;
  while (rows.size() < *count) {
    if (!next_line()) fail_cut_off(rows.size(), *count);
    rows.push_back(read_row(comment.columns, problems));
    if (rows.back().z != rows.front().z)
      problems.add(line_, 1, "z differs from the first disk's: disks lie in a plane");
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.id < b.id; });
  for (std::size_t k = 1; comment.columns.id && problems.empty() && k < rows.size(); ++k) {
    if (rows[k].id == rows[k - 1].id) problems.add(rows[k].line, 1, fmt::format("there are two disks {}", rows[k].id));
  }
  problems.throw_if_any();

  XyzFrame frame;
  frame.setup.system.box = comment.box;
  frame.setup.system.physics = comment.physics;
  frame.setup.frame.time = comment.time;
  for (const Row& row : rows) {
    frame.setup.system.add_disk(row.kind);
    frame.setup.frame.add_disk(row.position, row.velocity);
    frame.lines.push_back(row.line);
  }
  return frame;
}

std::optional<XyzFrames::Skipped> XyzFrames::skip_frame() {
  const std::optional<std::size_t> count = read_count();
  if (!count) return std::nullopt;
  Skipped skipped{.disks = *count, .time = 0, .line = line_};
  ProblemList problems(name_, kMostProblems);
  skipped.time = read_comment(problems).time;
  problems.throw_if_any();
  for (std::size_t row = 0; row < *count; ++row) {
    if (!next_line()) fail_cut_off(row, *count);
  }
  return skipped;
}

}  // namespace carom::io
