// Frames of an extended XYZ text, line by line from a stream.
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/state/scene.hpp"
#include "problem_list.hpp"
#include "words.hpp"
#include "xyz_comment.hpp"

namespace carom::io {

/// One frame, and on which line each disk stands.
struct XyzFrame {
  Setup setup;
  std::vector<int> lines;
};

class XyzFrames {
 public:
  /// `name` is what messages call the stream, which must outlive this.
  XyzFrames(std::istream& input, std::string name) : input_(input), name_(std::move(name)) {}

  /// The next frame, or nothing at the end. Throws Error with everything wrong with it.
  std::optional<XyzFrame> next();

  /// Passes over a frame's rows. Throws Error if its first two lines are malformed or it is cut off.
  struct Skipped {
    std::size_t disks = 0;
    double time = 0;
    int line = 0;  ///< of its number of disks
  };
  std::optional<Skipped> skip();

  /// From now on next() and skip() return nothing where the file ends in the middle of a frame that is not the first,
  /// and cut_off() is true.
  void allow_cut_off() noexcept { may_be_cut_off_ = true; }
  [[nodiscard]] bool cut_off() const noexcept { return cut_off_; }

  /// Starts again at the frame whose number of disks stands on this line, and where the stream is set to.
  void restart_at(int line) noexcept { line_ = line - 1; }

 private:
  struct Row;
  std::optional<XyzFrame> read_frame();
  std::optional<Skipped> skip_frame();
  bool next_line();
  std::optional<std::size_t> read_count();
  XyzComment read_comment(ProblemList& problems);
  [[noreturn]] void fail_cut_off(std::size_t found, std::size_t wanted) const;
  Row read_row(const XyzColumns& columns, ProblemList& problems);
  double read_number(std::size_t column, std::string_view what, ProblemList& problems) const;

  std::istream& input_;
  std::string name_;
  std::string text_;  // the current line
  std::vector<Word> words_;
  int line_ = 0;
  bool ended_ = false;      // the last line was asked for in vain, or has no line feed
  bool any_whole_ = false;  // frame was read
  bool may_be_cut_off_ = false;
  bool cut_off_ = false;
};

}  // namespace carom::io
