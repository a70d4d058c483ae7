// Scene files in TOML. The file is parsed by toml++; here its tables become a Scene and RunSettings.
#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "scene_reading.hpp"
#include "toml_section.hpp"

namespace carom::io {
namespace {

constexpr std::size_t kMostProblems = 100;

const TomlSection::Names<Boundary> kBoundaries{
    {"periodic", Boundary::periodic}, {"reflecting", Boundary::reflecting}, {"open", Boundary::open}};
const TomlSection::Names<GasStart> kStarts{{"lattice", GasStart::lattice}, {"random", GasStart::random}};

/// Puts a value that was given in the place of a default.
template <typename Target, typename Value>
void assign(Target& target, std::optional<Value>&& value) {
  if (value) target = std::move(*value);
}

/// Fills a ReadScene from the tables of one file.
class TomlReader {
 public:
  explicit TomlReader(const std::string& name) : problems_(name, kMostProblems) {}

  ReadScene read(const toml::table& root) {
    TomlSection top(root, "", problems_);
    top.find("title");
    const toml::table* box = top.table("box");
    const std::vector<const toml::table*> disks = top.tables("disk");
    const std::vector<const toml::table*> gases = top.tables("gas");
    const toml::table* physics = top.table("physics");
    const toml::table* run = top.table("run");
    const std::vector<const toml::table*> observe = top.tables("observe");
    top.refuse_other_keys();
    read_.understood = top.sound();

    assign(scene().title, top.text("title"));
    scene().box_place = scene().physics_place = problems_.at(0);
    if (box != nullptr) read_box(*box);
    for (const toml::table* disk : disks) read_disk(*disk);
    for (const toml::table* gas : gases) read_gas(*gas);
    if (physics != nullptr) read_physics(*physics);
    if (run != nullptr) read_run(*run);
    for (const toml::table* observable : observe) read_observe(*observable);
    read_.problems = problems_.in_order();
    return std::move(read_);
  }

 private:
  [[nodiscard]] Scene& scene() noexcept { return read_.file.scene; }

  [[nodiscard]] Place place_of(const toml::node& node) const {
    const toml::source_position& begin = node.source().begin;
    return problems_.at(static_cast<int>(begin.line), static_cast<int>(begin.column));
  }

  void read_box(const toml::table& table) {
    TomlSection section(table, "[box]", problems_);
    assign(scene().boundary, section.choice_per_axis("boundary", kBoundaries));
    const bool open = scene().boundary[0] == Boundary::open || scene().boundary[1] == Boundary::open;
    scene().size = section.two_numbers("size", open ? Range::zero_or_more : Range::positive);
    scene().aspect = section.number("aspect", Range::positive);
    const toml::node* size = section.find("size");
    scene().box_place = place_of(size != nullptr ? *size : table);
    if (const toml::node* aspect = section.find("aspect"); aspect != nullptr && size != nullptr) {
      section.complain(*aspect, "aspect is for a box without a size: leave one out");
    }
    section.refuse_other_keys();
    read_.box_sound = section.sound();
  }

  void read_disk(const toml::table& table) {
    TomlSection section(table, "[[disk]]", problems_);
    DiskSpec disk;
    disk.place = place_of(table);
    if (section.find("position") == nullptr) {
      section.complain(table, "this [[disk]] needs a position, e.g. position = [1.0, 2.0]");
    }
    assign(disk.position, section.two_numbers("position"));
    assign(disk.velocity, section.two_numbers("velocity"));
    assign(disk.radius, section.number("radius", Range::positive));
    assign(disk.mass, section.number("mass", Range::positive));
    section.refuse_other_keys();
    if (!section.sound()) read_.faulty_disks.push_back(scene().disks.size());
    scene().disks.push_back(std::move(disk));
  }

  void read_gas(const toml::table& table) {
    TomlSection section(table, "[[gas]]", problems_);
    GasSpec gas;
    gas.place = place_of(table);
    gas.count = section.count("count", 1);
    gas.packing_fraction = section.number("packing_fraction", Range::positive);
    assign(gas.radius, section.number("radius", Range::positive));
    assign(gas.mass, section.number("mass", Range::positive));
    assign(gas.temperature, section.number("temperature", Range::zero_or_more));
    assign(gas.seed, section.seed("seed"));
    assign(gas.start, section.choice("start", kStarts));
    section.refuse_other_keys();
    if (!section.sound()) read_.faulty_gas.push_back(scene().gas.size());
    scene().gas.push_back(std::move(gas));
  }

  void read_physics(const toml::table& table) {
    TomlSection section(table, "[physics]", problems_);
    scene().physics_place = place_of(table);
    assign(scene().restitution, section.number("restitution", Range::zero_to_one));
    scene().wall_restitution = section.number("wall_restitution", Range::zero_to_one);
    scene().t_c = section.number("t_c", Range::zero_or_more);
    section.refuse_other_keys();
  }

  void read_run(const toml::table& table) {
    TomlSection section(table, "[run]", problems_);
    RunSettings& run = read_.file.run;
    run.until = section.number("until", Range::positive);
    run.collisions = section.count("collisions", 1);
    assign(run.equilibrate, section.number("equilibrate", Range::zero_or_more));
    run.every = section.number("every", Range::positive);
    read_trajectory(section);
    section.refuse_other_keys();
  }

  void read_trajectory(TomlSection& section) {
    assign(read_.file.run.trajectory,
           section.choice("trajectory", TomlSection::Names<TrajectoryFormat>{{"xyz", TrajectoryFormat::xyz},
                                                                             {"h5md", TrajectoryFormat::h5md},
                                                                             {"none", TrajectoryFormat::none}}));
  }

  /// `name`, and options that only the observable knows: every other key is a number.
  void read_observe(const toml::table& table) {
    TomlSection section(table, "[[observe]]", problems_);
    ObserveSpec spec;
    spec.place = place_of(table);
    if (section.find("name") == nullptr) {
      section.complain(table, "this [[observe]] needs a name, e.g. name = \"pressure\"");
    }
    assign(spec.name, section.text("name"));
    for (const auto& [key, value] : table) {
      const std::string option(key.str());
      if (option == "name") continue;
      const toml::source_position& begin = key.source().begin;
      spec.places[option] = problems_.at(static_cast<int>(begin.line), static_cast<int>(begin.column));
      if (const std::optional<double> number = section.number(option)) spec.options[option] = *number;
    }
    if (section.sound()) read_.file.run.observe.push_back(std::move(spec));
  }

  ProblemList problems_;
  ReadScene read_;
};

/// Scenes have keys of two parts. toml++ makes a table of every part, one in the other, and takes them down by
/// recursion, which must not go deeper than there is stack; inline tables and arrays it limits itself.
constexpr int kMostPartsOfKey = 64;

/// The quote that ends what one begins; the beginning itself if it does not end on this line.
std::size_t end_of_quoted(std::string_view text, std::size_t begin) {
  for (std::size_t k = begin + 1; k < text.size() && text[k] != '\n'; ++k) {
    if (text[k] == text[begin]) return k;
    if (text[begin] == '"' && text[k] == '\\') ++k;
  }
  return begin;
}

/// Where a key has more parts than kMostPartsOfKey. What stands in quotes is passed over: it may hold anything.
std::optional<toml::source_position> overlong_key(std::string_view text) {
  toml::source_index line = 1;
  std::size_t line_start = 0;
  int parts = 1;
  for (std::size_t k = 0; k < text.size(); ++k) {
    switch (text[k]) {
      case '\n':
        ++line;
        line_start = k + 1;
        [[fallthrough]];
      case '=':
      case ',':
      case '[':
      case ']':
      case '{':
      case '}':
      case '#': parts = 1; break;
      case '"':
      case '\'': k = end_of_quoted(text, k); break;
      case '.':
        if (++parts > kMostPartsOfKey)
          return toml::source_position{line, static_cast<toml::source_index>(k - line_start + 1)};
        break;
      default: break;
    }
  }
  return std::nullopt;
}

ReadScene failed(const Place& place, std::string message) {
  ReadScene read;
  read.understood = false;
  read.problems.push_back({std::move(message), place});
  return read;
}

}  // namespace

ReadScene read_toml(std::string_view text, const std::string& name) {
  if (const auto at = overlong_key(text)) {
    return failed({name, static_cast<int>(at->line), static_cast<int>(at->column)},
                  fmt::format("not valid TOML: a key of more than {} parts", kMostPartsOfKey));
  }
  try {
    return TomlReader(name).read(toml::parse(text, name));
  } catch (const toml::parse_error& error) {
    const toml::source_position& at = error.source().begin;
    return failed({name, static_cast<int>(at.line), static_cast<int>(at.column)},
                  "not valid TOML: " + std::string(error.description()));
  } catch (const BrokenToml&) {
    return failed({name}, "not valid TOML");
  }
}

}  // namespace carom::io
