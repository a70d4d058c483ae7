// carom check and info: files looked at.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "carom/carom.hpp"
#include "command.hpp"

namespace carom::program {
namespace {

int check_command(const std::string& path) {
  const std::vector<Problem> problems =
      problems_in(path, [](const RunSettings& run) { return problems_of(run.observe); });
  if (!problems.empty()) throw Error(problems);
  print(display_name(path) + ": no problems\n");
  return kSuccess;
}

nlohmann::ordered_json boundary_of(const Box& box) { return {name_of(box.boundary[0]), name_of(box.boundary[1])}; }

/// What there is beside a scene.
struct FrameTimes {
  std::size_t count = 0;
  double first = 0;
  double last = 0;
  bool cut_off = false;
};

/// What `info` says, computed once for both ways of saying it.
struct Info {
  SceneFile file;
  Setup setup;
  std::optional<FrameTimes> frames;      // of a trajectory
  std::optional<Checkpoint> checkpoint;  // without its disks
};

Info checkpoint_info(const std::string& path) {
  Info info;
  info.checkpoint = read_checkpoint(path);
  Snapshot& snapshot = info.checkpoint->snapshot;
  info.setup = {std::move(snapshot.system), std::move(snapshot.state.disks)};
  info.file.scene.title = info.checkpoint->title;
  info.file.run = info.checkpoint->settings;
  return info;
}

/// The last whole frame of a trajectory, and how many there are.
Info trajectory_info(const std::string& path) {
  Info info;
  FrameTimes frames;
  const std::unique_ptr<TrajectoryReader> ahead = open_trajectory(path);
  const std::unique_ptr<TrajectoryReader> reader = open_trajectory(path);
  while (const std::optional<FrameHeader> header = ahead->skip()) {
    if (frames.count == 0) frames.first = header->time;
    if (frames.count++ > 0) reader->skip();
    frames.last = header->time;
  }
  frames.cut_off = ahead->cut_off();
  if (frames.count == 0) throw Error("there is no frame in this file", {path});
  info.setup = reader->next().value();
  info.frames = frames;
  return info;
}

Info read_info(const std::string& path) {
  const std::filesystem::path name(path);
  std::error_code unknown;
  const bool regular = path != "-" && std::filesystem::is_regular_file(name, unknown);
  if (is_checkpoint_file(path)) return checkpoint_info(path);
  const bool xyz = name.extension() == ".xyz" || name.extension() == ".extxyz";
  if (regular && (xyz || is_hdf5_file(path))) return trajectory_info(path);
  Info info;
  info.file = read_scene(path);
  info.setup = realize_here(info.file.scene);
  return info;
}

void add_times(const Info& info, nlohmann::ordered_json& json) {
  if (info.frames) {
    json["frames"] = info.frames->count;
    json["first_time"] = info.frames->first;
    json["last_time"] = info.frames->last;
    if (info.frames->cut_off) json["cut_off"] = true;
  }
  if (info.checkpoint) {
    const Snapshot& snapshot = info.checkpoint->snapshot;
    json["time"] = snapshot.state.clock.start;
    json["window"] = snapshot.state.clock.window;
    json["collisions_so_far"] = snapshot.books.collisions;
    json["wall_collisions_so_far"] = snapshot.books.wall_collisions;
    json["frames_so_far"] = info.checkpoint->files.frames;
  }
}

nlohmann::ordered_json as_json(const Info& info) {
  const System& system = info.setup.system;
  const Frame& frame = info.setup.frame;
  const double kT = temperature(system, frame);
  nlohmann::ordered_json json;
  json["title"] = info.file.scene.title;
  json["disks"] = system.size();
  add_times(info, json);
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

}  // namespace

void add_check(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "check", "Everything that is wrong with a scene", "carom check scenes/gas.toml");
  const auto path = std::make_shared<std::string>();
  command->add_option("SCENE", *path, "the scene file")->required()->type_name("");
  command->callback([path, &action] { action = [path] { return check_command(*path); }; });
}

void add_info(CLI::App& app, Action& action) {
  CLI::App* command =
      add_command(app, "info", "What a scene, trajectory or checkpoint holds", "carom info scenes/gas.toml");
  const auto path = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  command->add_option("FILE", *path, "a scene, an extended XYZ or H5MD trajectory, or a checkpoint")
      ->required()
      ->type_name("");
  command->add_flag("--json", *json, "print one JSON object");
  command->callback([path, json, &action] { action = [path, json] { return info_command(*path, *json); }; });
}

}  // namespace carom::program
