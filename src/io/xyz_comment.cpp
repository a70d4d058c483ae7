#include "xyz_comment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "numbers.hpp"
#include "words.hpp"

namespace carom::io {
namespace {

struct Entry {
  std::string_view key;
  std::string_view value;
  int column = 0;  // of the value
};

/// key=value, key="several words", or a key alone; OVITO and ASE also know braces and brackets.
std::vector<Entry> split_entries(std::string_view text) {
  std::vector<Entry> entries;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t\r,", at)) != std::string_view::npos) {
    const std::size_t key_end = std::min(text.find_first_of("= \t\r", at), text.size());
    Entry entry{text.substr(at, key_end - at), {}, static_cast<int>(at) + 1};
    at = key_end;
    if (at < text.size() && text[at] == '=') {
      constexpr std::string_view kOpening = "\"'{[";
      constexpr std::string_view kClosing = "\"'}]";
      const std::size_t quote = at + 1 < text.size() ? kOpening.find(text[at + 1]) : std::string_view::npos;
      const bool quoted = quote != std::string_view::npos;
      const std::size_t begin = at + (quoted ? 2 : 1);
      const std::size_t end = quoted ? text.find(kClosing[quote], begin) : text.find_first_of(" \t\r", begin);
      entry.value = text.substr(begin, std::min(end, text.size()) - begin);
      entry.column = static_cast<int>(begin) + 1;
      at = std::min(end, text.size()) + (quoted && end != std::string_view::npos ? 1 : 0);
    }
    entries.push_back(entry);
  }
  return entries;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

class CommentParser {
 public:
  CommentParser(std::string_view text, int line, ProblemList& problems)
      : entries_(split_entries(text)), line_(line), problems_(problems) {}

  XyzComment parse() {
    comment_.time = number("time").value_or(0);
    parse_box();
    parse_physics();
    parse_columns();
    return comment_;
  }

 private:
  const Entry* find(std::string_view key) const {
    const auto found =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return lower_case(e.key) == key; });
    return found == entries_.end() ? nullptr : &*found;
  }

  void complain(const Entry* entry, std::string message) {
    problems_.add(line_, entry == nullptr ? 0 : entry->column, std::move(message));
  }

  /// The numbers of a value; empty if the key is absent or there are not `count` finite numbers.
  std::vector<double> numbers(std::string_view key, std::size_t count) {
    const Entry* entry = find(key);
    if (entry == nullptr) return {};
    split_words(entry->value, words_);
    std::vector<double> values;
    for (const Word& word : words_) {
      const ParsedNumber number = parse_number(word.text);
      if (number.fault.empty()) values.push_back(number.value);
    }
    if (values.size() == count && words_.size() == count) return values;
    complain(entry, fmt::format("{} must be {} finite number{}", entry->key, count, count == 1 ? "" : "s"));
    return {};
  }

  std::optional<double> number(std::string_view key) {
    const std::vector<double> values = numbers(key, 1);
    return values.empty() ? std::nullopt : std::optional(values[0]);
  }

  void parse_box() {
    Box& box = comment_.box;
    box.boundary = {Boundary::open, Boundary::open};
    if (find("lattice") != nullptr) {
      parse_lattice();
      box.boundary = {Boundary::periodic, Boundary::periodic};  // what a lattice without pbc means
    }
    parse_pbc();
    parse_boundary();
    if (const std::vector<double> size = numbers("box", 2); !size.empty()) box.size = {size[0], size[1]};
  }

  void parse_lattice() {
    const std::vector<double> a = numbers("lattice", 9);
    if (a.empty()) return;
    if (a[1] != 0 || a[2] != 0 || a[3] != 0 || a[5] != 0 || a[6] != 0 || a[7] != 0) {
      complain(find("lattice"), "Lattice must be a rectangular box along the axes: \"Lx 0 0 0 Ly 0 0 0 Lz\"");
    }
    comment_.box.size = {a[0], a[4]};
  }

  void parse_pbc() {
    const Entry* entry = find("pbc");
    if (entry == nullptr) return;
    split_words(entry->value, words_);
    for (int axis = 0; axis < 2; ++axis) {
      const std::string flag = axis < static_cast<int>(words_.size()) ? lower_case(words_[axis].text) : "";
      const bool yes = flag == "t" || flag == "true" || flag == "1";
      const bool no = flag == "f" || flag == "false" || flag == "0";
      if (!yes && !no) return complain(entry, "pbc must be T or F for each axis, e.g. \"T T F\"");
      comment_.box.boundary[axis] = yes ? Boundary::periodic : Boundary::reflecting;
    }
  }

  void parse_boundary() {
    const Entry* entry = find("boundary");
    if (entry == nullptr) return;
    split_words(entry->value, words_);
    for (int axis = 0; axis < 2; ++axis) {
      bool known = false;
      for (const Boundary boundary : {Boundary::periodic, Boundary::reflecting, Boundary::open}) {
        if (words_.size() != 2 || words_[axis].text != name_of(boundary)) continue;
        comment_.box.boundary[axis] = boundary;
        known = true;
      }
      if (!known) return complain(entry, "boundary must be two of periodic, reflecting, open");
    }
  }

  void parse_physics() {
    Physics& physics = comment_.physics;
    physics.restitution = number("restitution").value_or(1);
    physics.wall_restitution = number("wall_restitution").value_or(physics.restitution);
    physics.t_c = number("t_c").value_or(0);
  }

  /// Properties=name:type:words:…
  void parse_columns() {
    const Entry* entry = find("properties");
    if (entry == nullptr) return complain(nullptr, "no Properties: they say what the columns are");
    bool position = false;
    bool velocity = false;
    bool radius = false;
    XyzColumns& columns = comment_.columns;
    std::string_view rest = entry->value;
    while (!rest.empty()) {
      const std::string name = lower_case(take_field(rest));
      const std::string_view type = take_field(rest);
      const std::optional<std::uint64_t> words = parse_count(take_field(rest));
      if (!words || *words == 0 || *words > 100 || type.size() != 1) {
        return complain(entry, "Properties must be name:type:columns, again and again");
      }
      const std::size_t first = columns.words;
      columns.words += *words;
      const bool vector = *words == 2 || *words == 3;
      if (name == "pos" && vector) {
        position = true, columns.position = first, columns.position_words = *words;
      } else if ((name == "velo" || name == "vel" || name == "velocities") && vector) {
        velocity = true, columns.velocity = first, columns.velocity_words = *words;
      } else if (name == "radius") {
        radius = true, columns.radius = first;
      } else if (name == "mass" || name == "masses") {
        columns.mass = first;
      } else if (name == "id") {
        columns.id = first;
      }
    }
    if (!position) complain(entry, "Properties has no pos:R:3");
    if (!velocity) complain(entry, "Properties has no velo:R:3");
    if (!radius) complain(entry, "Properties has no radius:R:1");
  }

  static std::string_view take_field(std::string_view& rest) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::string_view field = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return field;
  }

  std::vector<Entry> entries_;
  int line_;
  ProblemList& problems_;
  std::vector<Word> words_;
  XyzComment comment_;
};

}  // namespace

XyzComment parse_xyz_comment(std::string_view text, int line, ProblemList& problems) {
  return CommentParser(text, line, problems).parse();
}

}  // namespace carom::io
