#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "carom/io/scene_file.hpp"

namespace carom {
namespace {

/// Writes a scene file, key by key; what is at its default is left out where that reads well.
class TomlWriter {
 public:
  std::string write(const SceneFile& file) {
    if (!file.scene.title.empty()) append("title = {}\n\n", quoted(file.scene.title));
    write_box(file.scene);
    write_physics(file.scene);
    write_run(file.run);
    for (const GasSpec& gas : file.scene.gas) write_gas(gas);
    for (const DiskSpec& disk : file.scene.disks) write_disk(disk);
    return fmt::to_string(text_);
  }

 private:
  template <typename... Arguments>
  void append(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }

  /// The shortest decimals that read back to the same bits, as a TOML float.
  void append_float(double value) {
    const std::size_t begin = text_.size();
    append("{}", value);
    const std::string_view written(text_.data() + begin, text_.size() - begin);
    if (written.find_first_of(".en") == std::string_view::npos) append(".0");
  }

  void key(std::string_view name, double value) {
    append("{} = ", name);
    append_float(value);
    append("\n");
  }

  void key(std::string_view name, const std::optional<double>& value) {
    if (value) key(name, *value);
  }

  void key(std::string_view name, Vec2 value) {
    append("{} = [", name);
    append_float(value.x);
    append(", ");
    append_float(value.y);
    append("]\n");
  }

  /// A basic string: JSON's escapes are TOML's, except that TOML wants DEL escaped, too.
  static std::string quoted(const std::string& text) {
    using nlohmann::json;
    std::string escaped;
    for (const char c : json(text).dump(-1, ' ', false, json::error_handler_t::replace)) {
      if (c == '\x7f') {
        escaped += "\\u007F";
      } else {
        escaped += c;
      }
    }
    return escaped;
  }

  void write_box(const Scene& scene) {
    append("[box]\n");
    if (scene.size) {
      key("size", *scene.size);
    } else {
      key("aspect", scene.aspect);
    }
    const auto [x, y] = scene.boundary;
    if (x == y) {
      append("boundary = \"{}\"\n", name_of(x));
    } else {
      append("boundary = [\"{}\", \"{}\"]\n", name_of(x), name_of(y));
    }
  }

  void write_physics(const Scene& scene) {
    append("\n[physics]\n");
    key("restitution", scene.restitution);
    key("wall_restitution", scene.wall_restitution);
    key("t_c", scene.t_c);
  }

  void write_run(const RunSettings& run) {
    append("\n[run]\n");
    key("until", run.until);
    if (run.collisions) append("collisions = {}\n", *run.collisions);
    if (run.equilibrate != 0) key("equilibrate", run.equilibrate);
    key("every", run.every);
    if (run.trajectory == TrajectoryFormat::xyz) append("trajectory = \"xyz\"\n");
    for (const ObserveSpec& spec : run.observe) write_observe(spec);
  }

  void write_observe(const ObserveSpec& spec) {
    append("\n[[observe]]\nname = {}\n", quoted(spec.name));
    for (const auto& [option, value] : spec.options) key(option, value);
  }

  void write_gas(const GasSpec& gas) {
    append("\n[[gas]]\n");
    if (gas.count) append("count = {}\n", *gas.count);
    key("packing_fraction", gas.packing_fraction);
    key("radius", gas.radius);
    key("mass", gas.mass);
    key("temperature", gas.temperature);
    constexpr std::uint64_t kLargestInteger = INT64_MAX;  // of TOML
    if (gas.seed <= kLargestInteger) {
      append("seed = {}\n", gas.seed);
    } else {
      append("seed = \"{}\"\n", gas.seed);
    }
    append("start = \"{}\"\n", gas.start == GasStart::lattice ? "lattice" : "random");
  }

  void write_disk(const DiskSpec& disk) {
    append("\n[[disk]]\n");
    key("position", disk.position);
    key("velocity", disk.velocity);
    key("radius", disk.radius);
    key("mass", disk.mass);
  }

  fmt::memory_buffer text_;
};

}  // namespace

std::string to_toml(const SceneFile& file) { return TomlWriter().write(file); }

}  // namespace carom
