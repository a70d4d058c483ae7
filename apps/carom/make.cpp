// carom make: scenes from a few numbers.
#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <map>
#include <memory>
#include <string>

#include "carom/carom.hpp"
#include "command.hpp"
#include "options.hpp"

namespace carom::program {
namespace {

const std::map<std::string, Boundary> kBoundaries{
    {"periodic", Boundary::periodic}, {"reflecting", Boundary::reflecting}, {"open", Boundary::open}};
const std::map<std::string, GasStart> kStarts{{"lattice", GasStart::lattice}, {"random", GasStart::random}};

/// The name of the file to write, and how the scene for it is made.
struct MakeOptions {
  std::string out;
  std::function<SceneFile()> make;
  bool list = false;
};

/// Checks that the scene can be simulated, then writes it.
int make_command(const MakeOptions& options) {
  const SceneFile file = options.make();
  const Setup setup = realize_here(file.scene);
  const std::string toml = to_toml(file);
  if (options.out == "-") {
    print(toml);
  } else {
    write_file(options.out, toml);
    tell(fmt::format("wrote {}: {}, {} disk{}", options.out, file.scene.title, setup.system.size(),
                     setup.system.size() == 1 ? "" : "s"));
  }
  return kSuccess;
}

CLI::App* add_scene(CLI::App& make, const std::shared_ptr<MakeOptions>& options, const std::string& name,
                    const std::string& description, const std::string& example, std::function<SceneFile()> scene,
                    Action& action) {
  CLI::App* command = add_command(make, name, description, example);
  add_path(*command, "-o,--output", options->out, "FILE", "the scene file to write (- for standard output)")
      ->required();
  command->callback([options, scene = std::move(scene), &action] {
    options->make = scene;
    action = [options] { return make_command(*options); };
  });
  return command;
}

void add_gas(CLI::App& make, const std::shared_ptr<MakeOptions>& options, Action& action) {
  const auto preset = std::make_shared<GasPreset>();
  CLI::App* command = add_scene(
      make, options, "gas", "A gas of one or two kinds of disks in a box",
      "carom make gas --disks 400 --packing 0.5 --seed 7 -o gas.toml", [preset] { return make_gas(*preset); }, action);
  add_count(*command, "--disks", preset->disks, "number of disks")->required();
  add_number(*command, "--packing", preset->packing, "packing fraction of all disks together")->required();
  add_number(*command, "--temperature", preset->temperature, "kT (1)");
  add_count(*command, "--seed", preset->seed, "of the velocities and places (1)");
  add_choice(*command, "--boundary", preset->boundary, kBoundaries, "periodic, reflecting or open");
  add_number(*command, "--radius-ratio", preset->radius_ratio,
             "radius of the second kind of disks over that of the first");
  add_number(*command, "--mass-ratio", preset->mass_ratio, "mass of the second kind over that of the first");
  add_number(*command, "--fraction", preset->fraction, "share of disks of the second kind (0.5)");
  add_number(*command, "--aspect", preset->aspect, "height of the box over its width");
  add_choice(*command, "--start", preset->start, kStarts, "where the disks start: lattice or random");
}

std::string list_of_scenes(const CLI::App& make) {
  std::string text;
  for (const CLI::App* scene : make.get_subcommands({})) {
    text += fmt::format("{:<10} {}\n", scene->get_name(), scene->get_description());
  }
  return text;
}

}  // namespace

void add_make(CLI::App& app, Action& action) {
  CLI::App* make =
      add_command(app, "make", "Make a scene file", "carom make gas --disks 400 --packing 0.5 -o gas.toml");
  make->require_subcommand(0, 1);
  const auto options = std::make_shared<MakeOptions>();
  make->add_flag("--list", options->list, "list the scenes that can be made");
  // The subcommand's own callback runs after this one and has the last word.
  make->callback([make, options, &action] {
    if (!options->list && make->get_subcommands().empty()) {
      throw UsageError("which scene? 'carom make --list' lists them");
    }
    if (options->list) action = [make] { return print(list_of_scenes(*make)), kSuccess; };
  });

  add_gas(*make, options, action);
  add_scene(*make, options, "two-disk", "Two equal disks, one at rest, meeting at an angle",
            "carom make two-disk -o two-disk.toml", make_two_disks, action);
  const auto cradle_disks = std::make_shared<std::uint64_t>(5);
  CLI::App* cradle = add_scene(
      *make, options, "cradle", "Newton's cradle between two walls", "carom make cradle --disks 5 -o cradle.toml",
      [cradle_disks] { return make_cradle(*cradle_disks); }, action);
  add_count(*cradle, "--disks", *cradle_disks, "number of disks, the incoming one included (5)");
  add_scene(*make, options, "break", "The break on a pool table", "carom make break -o break.toml", make_break, action);
  const auto digits = std::make_shared<std::uint64_t>(4);
  CLI::App* galperin = add_scene(
      *make, options, "galperin", "Galperin's billiard: collisions count digits of pi",
      "carom make galperin --digits 4 -o galperin.toml",
      [digits] { return make_galperin(static_cast<int>(std::min<std::uint64_t>(*digits, INT_MAX))); }, action);
  add_count(*galperin, "--digits", *digits, "digits of pi, from 1 to 7 (4): disk-disk contacts and wall hits together");
  const auto seed = std::make_shared<std::uint64_t>(1);
  CLI::App* brownian = add_scene(
      *make, options, "brownian", "A heavy disk in a gas of light ones", "carom make brownian -o brownian.toml",
      [seed] { return make_brownian(*seed); }, action);
  add_count(*brownian, "--seed", *seed, "of the velocities (1)");
}

}  // namespace carom::program
