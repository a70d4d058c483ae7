#include "carom/carom/scene_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "carom/base/error.hpp"

namespace carom {
namespace {

std::uint64_t whole(const std::string& key, double value, double least) {
  constexpr double kExactIntegers = 0x1p53;
  if (!(value >= least && value < kExactIntegers && value == std::rint(value))) {
    throw Error(fmt::format("{} = {}: it must be a whole number, {} or more", key, value, least));
  }
  return static_cast<std::uint64_t>(value);
}

/// Where the packing fraction is to set the box: gives its size up and keeps its shape.
void let_packing_set_the_box(Scene& scene, const std::string& key) {
  if (!scene.disks.empty()) {
    throw Error(fmt::format("{}: the scene has [[disk]]s, whose places belong to the box as it is", key));
  }
  if (!scene.size) return;
  scene.aspect = scene.size->y / scene.size->x;
  scene.size.reset();
}

void require_gas(const Scene& scene, const std::string& key, std::size_t least = 1) {
  if (scene.gas.size() >= least) return;
  throw Error(least == 1 ? fmt::format("{}: the scene has no [[gas]]", key)
                         : fmt::format("{}: the scene has fewer than {} [[gas]]es", key, least));
}

void set_packing(Scene& scene, const std::string& key, double value) {
  require_gas(scene, key);
  const bool fractions = std::all_of(scene.gas.begin(), scene.gas.end(),
                                     [](const GasSpec& gas) { return gas.packing_fraction.has_value(); });
  const bool counts =
      std::all_of(scene.gas.begin(), scene.gas.end(), [](const GasSpec& gas) { return gas.count.has_value(); });
  if (!fractions && !counts) {
    throw Error(fmt::format("{}: every [[gas]] needs a count, or every one a packing_fraction", key));
  }
  const auto share = [&](const GasSpec& gas) {
    return counts ? static_cast<double>(*gas.count) * gas.radius * gas.radius : *gas.packing_fraction;
  };
  double all = 0;
  for (const GasSpec& gas : scene.gas) all += share(gas);
  if (counts) let_packing_set_the_box(scene, key);
  for (GasSpec& gas : scene.gas) gas.packing_fraction = value * (share(gas) / all);
}

void set_disks(Scene& scene, const std::string& key, double value) {
  require_gas(scene, key);
  if (scene.gas.size() > 1) throw Error(fmt::format("{}: the scene has several [[gas]]es: say gas.1.count", key));
  GasSpec& gas = scene.gas.front();
  if (gas.packing_fraction) let_packing_set_the_box(scene, key);
  gas.count = whole(key, value, 1);
}

void set_aspect(Scene& scene, double value) {
  if (!scene.size) {
    scene.aspect = value;
    return;
  }
  const double area = scene.size->x * scene.size->y;
  scene.size = Vec2{std::sqrt(area / value), std::sqrt(area * value)};
}

using SetGas = std::function<void(GasSpec&, const std::string& key, double value)>;
using SetDisk = std::function<void(DiskSpec&, double value)>;
using SetFile = std::function<void(SceneFile&, const std::string& key, double value)>;

const std::map<std::string, SetGas, std::less<>> kGasKeys{
    {"count", [](GasSpec& gas, const std::string& key, double value) { gas.count = whole(key, value, 1); }},
    {"packing_fraction", [](GasSpec& gas, const std::string&, double value) { gas.packing_fraction = value; }},
    {"radius", [](GasSpec& gas, const std::string&, double value) { gas.radius = value; }},
    {"mass", [](GasSpec& gas, const std::string&, double value) { gas.mass = value; }},
    {"temperature", [](GasSpec& gas, const std::string&, double value) { gas.temperature = value; }},
    {"seed", [](GasSpec& gas, const std::string& key, double value) { gas.seed = whole(key, value, 0); }},
};

const std::map<std::string, SetDisk, std::less<>> kDiskKeys{
    {"radius", [](DiskSpec& disk, double value) { disk.radius = value; }},
    {"mass", [](DiskSpec& disk, double value) { disk.mass = value; }},
};

const std::map<std::string, SetFile, std::less<>> kFileKeys{
    {"packing", [](SceneFile& file, const std::string& key, double value) { set_packing(file.scene, key, value); }},
    {"disks", [](SceneFile& file, const std::string& key, double value) { set_disks(file.scene, key, value); }},
    {"count", [](SceneFile& file, const std::string& key, double value) { set_disks(file.scene, key, value); }},
    {"box.aspect", [](SceneFile& file, const std::string&, double value) { set_aspect(file.scene, value); }},
    {"physics.restitution", [](SceneFile& file, const std::string&, double value) { file.scene.restitution = value; }},
    {"physics.wall_restitution",
     [](SceneFile& file, const std::string&, double value) { file.scene.wall_restitution = value; }},
    {"physics.t_c", [](SceneFile& file, const std::string&, double value) { file.scene.t_c = value; }},
    {"run.until", [](SceneFile& file, const std::string&, double value) { file.run.until = value; }},
    {"run.collisions",
     [](SceneFile& file, const std::string& key, double value) { file.run.collisions = whole(key, value, 1); }},
    {"run.equilibrate", [](SceneFile& file, const std::string&, double value) { file.run.equilibrate = value; }},
    {"run.every", [](SceneFile& file, const std::string&, double value) { file.run.every = value; }},
    {"radius_ratio",
     [](SceneFile& file, const std::string& key, double value) {
       require_gas(file.scene, key, 2);
       file.scene.gas[1].radius = value * file.scene.gas[0].radius;
     }},
    {"mass_ratio",
     [](SceneFile& file, const std::string& key, double value) {
       require_gas(file.scene, key, 2);
       file.scene.gas[1].mass = value * file.scene.gas[0].mass;
     }},
};

const std::map<std::string, std::string, std::less<>> kShortKeys{
    {"aspect", "box.aspect"},
    {"temperature", "gas.temperature"},
    {"seed", "gas.seed"},
    {"radius", "gas.radius"},
    {"mass", "gas.mass"},
    {"restitution", "physics.restitution"},
    {"wall_restitution", "physics.wall_restitution"},
};

/// "gas.2.mass": the section's name, which of its kind, and what is behind the last dot.
struct KeyWords {
  std::string section;
  std::string middle;  // a number, or the name of an observable; may be empty
  std::string name;
};

KeyWords words_of(const std::string& key) {
  const std::size_t first = key.find('.'), last = key.rfind('.');
  if (first == std::string::npos) return {"", "", key};
  const std::string middle = first == last ? "" : key.substr(first + 1, last - first - 1);
  return {key.substr(0, first), middle, key.substr(last + 1)};
}

/// The entries that a key names: all of them, or the one with its number, counted from 1.
template <typename Spec>
std::vector<Spec*> chosen(std::vector<Spec>& specs, const KeyWords& words, const std::string& key) {
  std::vector<Spec*> all;
  for (Spec& spec : specs) all.push_back(&spec);
  if (all.empty()) throw Error(fmt::format("{}: the scene has no [[{}]]", key, words.section));
  if (words.middle.empty()) return all;
  const bool digits = words.middle.size() < 10 && words.middle.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t number = digits ? std::stoul(words.middle) : 0;
  if (number < 1 || number > all.size()) {
    throw Error(fmt::format("{}: the scene's [[{}]]s are numbered from 1 to {}", key, words.section, all.size()));
  }
  return {all[number - 1]};
}

[[noreturn]] void refuse(const std::string& key) {
  std::vector<std::string> known;
  for (const auto& [name, set] : kFileKeys) {
    if (name.find('.') == std::string::npos) known.push_back(name);
  }
  for (const auto& [name, full] : kShortKeys) known.push_back(name);
  std::sort(known.begin(), known.end());
  throw Error(
      fmt::format("'{}' cannot be varied; what can: {}, and the numbers of [[gas]], [[disk]] and [[observe]], "
                  "such as gas.mass or gas.2.mass",
                  key, fmt::join(known, ", ")));
}

void set_observe_option(RunSettings& run, const KeyWords& words, const std::string& key, double value) {
  bool found = false;
  for (ObserveSpec& observe : run.observe) {
    if (observe.name != words.middle) continue;
    observe.options[words.name] = value;
    found = true;
  }
  if (!found) throw Error(fmt::format("{}: nothing called '{}' is observed", key, words.middle));
}

}  // namespace

std::string full_scene_key(const std::string& key) {
  const auto found = kShortKeys.find(key);
  return found == kShortKeys.end() ? key : found->second;
}

void set_scene_key(SceneFile& file, const std::string& key, double value) {
  const std::string full = full_scene_key(key);
  if (const auto found = kFileKeys.find(full); found != kFileKeys.end()) return found->second(file, key, value);
  const KeyWords words = words_of(full);
  if (words.section == "gas" && kGasKeys.contains(words.name)) {
    for (GasSpec* gas : chosen(file.scene.gas, words, key)) kGasKeys.at(words.name)(*gas, key, value);
  } else if (words.section == "disk" && kDiskKeys.contains(words.name)) {
    for (DiskSpec* disk : chosen(file.scene.disks, words, key)) kDiskKeys.at(words.name)(*disk, value);
  } else if (words.section == "observe" && !words.middle.empty()) {
    set_observe_option(file.run, words, key, value);
  } else {
    refuse(key);
  }
}

}  // namespace carom
