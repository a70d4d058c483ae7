// carom draw: a state as a picture.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "carom/carom.hpp"
#include "command.hpp"
#ifdef CAROM_HAS_DRAW
#include "carom/draw/state.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#endif

namespace carom::program {
#ifdef CAROM_HAS_DRAW
namespace {

const std::map<std::string, ColourBy> kColours{{"species", ColourBy::species}, {"speed", ColourBy::speed}};

struct DrawOptions {
  std::string file;
  std::string out;
  std::optional<double> time;
  StatePicture picture;
};

int draw_command(const DrawOptions& options) {
  const PictureFormat format = picture_format_of(options.out);
  if (options.time && !(*options.time >= 0 && std::isfinite(*options.time))) {
    throw Error(fmt::format("--time {}: it must be a finite time, 0 or more", *options.time));
  }
  const SceneFile file = read_scene(options.file);
  Simulation simulation(realize_here(file.scene));
  simulation.stop_when(catch_interrupts());
  if (options.time && simulation.run_until(*options.time) == Simulation::Stop::interrupted) return kInterrupted;
  StatePicture picture = options.picture;
  if (picture.title.empty()) picture.title = file.scene.title;
  write_file(options.out, picture_of_state(simulation.system(), simulation.frame(), picture, format));
  return kSuccess;
}

}  // namespace

void add_draw(CLI::App& app, Action& action) {
  CLI::App* command =
      add_command(app, "draw", "A picture of a scene", "carom draw scenes/gas.toml --time 2 -o gas.svg");
  const auto options = std::make_shared<DrawOptions>();
  command->add_option("FILE", options->file, "a scene, or an extended XYZ file (its last frame)")
      ->required()
      ->type_name("");
  command->add_option("-o,--output", options->out, "the picture: a name ending in .svg, .png or .pdf")
      ->required()
      ->type_name("FILE");
  add_number(*command, "--time", options->time, "simulate to this time first");
  add_choice(*command, "--colour,--color", options->picture.colour, kColours, "by species or by speed");
  command->add_flag("--velocities", options->picture.velocities, "draw the velocities as arrows");
  add_number(*command, "--width", options->picture.width_px, "of the picture in pixels (1000)");
  command->add_option("--title", options->picture.title, "above the picture (the scene's)");
  command->callback([options, &action] { action = [options] { return draw_command(*options); }; });
}
#else
void add_draw(CLI::App& /*app*/, Action& /*action*/) {}  // built without pictures: there is no such command
#endif

}  // namespace carom::program
