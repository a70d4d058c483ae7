// The text files of CollisionSystem in Sedgewick and Wayne's algs4: the number of disks, then a row
// "rx ry vx vy radius mass r g b" for each, in a box with walls at 0 and 1.
#include <fmt/format.h>

#include <array>

#include "numbers.hpp"
#include "problem_list.hpp"
#include "scene_reading.hpp"
#include "words.hpp"

namespace carom::io {
namespace {

constexpr std::size_t kMostProblems = 20;
constexpr std::size_t kColumns = 9;
constexpr std::array<std::string_view, kColumns> kNames{"rx", "ry", "vx", "vy", "radius", "mass", "r", "g", "b"};

class Algs4Reader {
 public:
  Algs4Reader(std::string_view text, const std::string& name) : text_(text), problems_(name, kMostProblems) {
    Scene& scene = read_.file.scene;
    scene.size = Vec2{1, 1};
    scene.boundary = {Boundary::reflecting, Boundary::reflecting};
    scene.box_place = scene.physics_place = problems_.at(1);
  }

  ReadScene read() {
    const std::uint64_t count = read_count();
    while (read_.understood && next_row()) {
      if (read_.file.scene.disks.size() == count) {
        problems_.add(line_, words_[0].column, fmt::format("text after the last of {} disks", count));
        read_.understood = false;
      } else {
        read_row();
      }
    }
    const std::size_t rows = read_.file.scene.disks.size();
    if (read_.understood && rows < count) {
      problems_.add(line_, 0, fmt::format("the file ends after {} of {} disks", rows, count));
    }
    read_.problems = problems_.in_order();
    return std::move(read_);
  }

 private:
  /// Goes to the next line that is not blank and splits it into words_.
  bool next_row() {
    while (!text_.empty()) {
      ++line_;
      split_words(take_line(text_), words_);
      if (!words_.empty()) return true;
    }
    return false;
  }

  std::uint64_t read_count() {
    const bool found = next_row();
    const std::optional<std::uint64_t> count = found ? parse_count(words_[0].text) : std::nullopt;
    if (count && *count > 0 && words_.size() == 1) return *count;
    read_.understood = false;
    problems_.add(line_, found ? words_[0].column : 0,
                  count == 0 ? "the number of disks is 0: there must be at least one"
                             : "the first line must be the number of disks");
    return 0;
  }

  void read_row() {
    DiskSpec disk;
    disk.place = problems_.at(line_, words_[0].column);
    const std::array<double*, kColumns> targets{&disk.position.x, &disk.position.y, &disk.velocity.x,
                                                &disk.velocity.y, &disk.radius,     &disk.mass,
                                                nullptr,          nullptr,          nullptr};
    const std::size_t before = problems_.size();
    if (words_.size() == kColumns) {
      for (std::size_t k = 0; k < kColumns; ++k) read_number(k, targets[k]);
    } else {
      problems_.add(line_, words_[0].column,
                    fmt::format("{} columns: there must be 9, {}", words_.size(), fmt::join(kNames, " ")));
    }
    if (problems_.size() > before) read_.faulty_disks.push_back(read_.file.scene.disks.size());
    read_.file.scene.disks.push_back(std::move(disk));
  }

  /// Colours have no target: they are checked and dropped.
  void read_number(std::size_t column, double* target) {
    const Word& word = words_[column];
    const ParsedNumber number = parse_number(word.text);
    const bool must_be_positive = kNames[column] == "radius" || kNames[column] == "mass";
    if (!number.fault.empty()) {
      problems_.add(line_, word.column, fmt::format("{} '{}' {}", kNames[column], word.text, number.fault));
    } else if (must_be_positive && !(number.value > 0)) {
      problems_.add(line_, word.column,
                    fmt::format("{} is {}: it must be greater than 0", kNames[column], number.value));
    } else if (target != nullptr) {
      *target = number.value;
    }
  }

  std::string_view text_;
  ProblemList problems_;
  ReadScene read_;
  std::vector<Word> words_;
  int line_ = 0;
};

}  // namespace

ReadScene read_algs4(std::string_view text, const std::string& name) { return Algs4Reader(text, name).read(); }

}  // namespace carom::io
