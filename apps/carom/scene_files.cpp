// carom check, info, convert: scene files looked at and rewritten.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "carom/carom.hpp"
#include "command.hpp"

namespace carom::program {
namespace {

std::string ending_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const std::size_t dot = path.find_last_of('.');
  const bool has_ending = dot != std::string::npos && (slash == std::string::npos || dot > slash);
  return has_ending ? path.substr(dot) : "";
}

int check_command(const std::string& path) {
  const std::vector<Problem> problems =
      problems_in(path, [](const RunSettings& run) { return problems_of(run.observe); });
  if (!problems.empty()) throw Error(problems);
  print(display_name(path) + ": no problems\n");
  return kSuccess;
}

nlohmann::ordered_json boundary_of(const Box& box) { return {name_of(box.boundary[0]), name_of(box.boundary[1])}; }

/// What `info` says, computed once for both ways of saying it.
struct Info {
  SceneFile file;
  Setup setup;
  std::optional<std::size_t> frames;  // of an XYZ file
};

Info read_info(const std::string& path) {
  Info info;
  info.file = read_scene(path);
  info.setup = realize_here(info.file.scene);
  if (ending_of(path) != ".xyz") return info;
  XyzReader reader(path);
  info.frames = 0;
  while (reader.skip()) ++*info.frames;
  return info;
}

nlohmann::ordered_json as_json(const Info& info) {
  const System& system = info.setup.system;
  const Frame& frame = info.setup.frame;
  const double kT = temperature(system, frame);
  nlohmann::ordered_json json;
  json["title"] = info.file.scene.title;
  json["disks"] = system.size();
  if (info.frames) json["frames"] = *info.frames;
  json["box"] = {system.box.size.x, system.box.size.y};
  json["boundary"] = boundary_of(system.box);
  const double eta = packing_fraction(system);
  json["packing_fraction"] = eta > 0 ? nlohmann::ordered_json(eta) : nlohmann::ordered_json();
  for (const Species& kind : system.species) {
    nlohmann::ordered_json entry;
    entry["radius"] = kind.radius;
    entry["mass"] = kind.mass;
    entry["disks"] = std::count_if(system.species_of.begin(), system.species_of.end(),
                                   [&](std::uint32_t index) { return system.species[index] == kind; });
    json["species"].push_back(entry);
  }
  json["restitution"] = system.physics.restitution;
  json["wall_restitution"] = system.physics.wall_restitution;
  json["t_c"] = system.physics.t_c;
  json["energy"] = kinetic_energy(system, frame);
  json["momentum"] = {momentum(system, frame).x, momentum(system, frame).y};
  json["temperature"] = std::isnan(kT) ? nlohmann::ordered_json() : nlohmann::ordered_json(kT);
  const RunSettings& run = info.file.run;
  json["until"] = run.until ? nlohmann::ordered_json(*run.until) : nlohmann::ordered_json();
  json["collisions"] = run.collisions ? nlohmann::ordered_json(*run.collisions) : nlohmann::ordered_json();
  json["scene_digest"] = digest(system, frame);
  return json;
}

std::string as_text(const nlohmann::ordered_json& json) {
  std::string text;
  for (const auto& [key, value] : json.items()) {
    if (key != "species") {
      text += fmt::format("{:<18} {}\n", key,
                          value.is_string() ? value.get<std::string>()
                          : value.is_null() ? "-"
                                            : value.dump());
      continue;
    }
    constexpr std::size_t kMostShown = 10;
    for (std::size_t k = 0; k < std::min(value.size(), kMostShown); ++k) {
      text += fmt::format("{:<18} {} of radius {}, mass {}\n", k == 0 ? "species" : "", value[k]["disks"].dump(),
                          value[k]["radius"].dump(), value[k]["mass"].dump());
    }
    if (value.size() > kMostShown) text += fmt::format("{:<18} and {} more\n", "", value.size() - kMostShown);
  }
  return text;
}

int info_command(const std::string& path, bool json) {
  const nlohmann::ordered_json info = as_json(read_info(path));
  print(json ? info.dump(2) + "\n" : as_text(info));
  return kSuccess;
}

int convert_command(const std::string& in, const std::string& out) {
  const std::string ending = ending_of(out);
  if (ending != ".toml" && ending != ".xyz") {
    throw Error(fmt::format("cannot convert to {}: give a name that ends in .toml or .xyz", out));
  }
  SceneFile file = read_scene(in);
  const Setup setup = realize_here(file.scene);
  if (ending == ".xyz") {
    write_file(out, xyz_frame(setup.system, setup.frame));
  } else {
    file.scene = explicit_scene(setup, file.scene.title);
    write_file(out, to_toml(file));
  }
  return kSuccess;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "check", "Everything that is wrong with a scene", "carom check scenes/gas.toml");
  const auto path = std::make_shared<std::string>();
  command->add_option("SCENE", *path, "the scene file")->required()->type_name("");
  command->callback([path, &action] { action = [path] { return check_command(*path); }; });
}

void add_info(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "info", "What a scene or trajectory holds", "carom info scenes/gas.toml");
  const auto path = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  command->add_option("FILE", *path, "the scene or extended XYZ file")->required()->type_name("");
  command->add_flag("--json", *json, "print one JSON object");
  command->callback([path, json, &action] { action = [path, json] { return info_command(*path, *json); }; });
}

void add_convert(CLI::App& app, Action& action) {
  CLI::App* command =
      add_command(app, "convert", "Rewrite a scene in another format", "carom convert scenes/gas.toml gas.xyz");
  const auto in = std::make_shared<std::string>();
  const auto out = std::make_shared<std::string>();
  command->add_option("IN", *in, "TOML, algs4 text or extended XYZ")->required()->type_name("");
  command->add_option("OUT", *out, "a name ending in .toml or .xyz")->required()->type_name("");
  command->callback([in, out, &action] { action = [in, out] { return convert_command(*in, *out); }; });
}

}  // namespace carom::program
