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

bool is_xyz(const std::string& path) { return path.size() > 4 && path.substr(path.size() - 4) == ".xyz"; }

/// The frame of an extended XYZ file that is nearest in time, the last one if no time is given.
Setup frame_of(const std::string& path, const std::optional<double>& time) {
  if (!time) return read_last_frame(path);
  XyzReader reader(path);
  std::optional<Setup> nearest = reader.next();
  if (!nearest) throw Error("there are no frames", {path, 0, 0});
  while (std::optional<Setup> frame = reader.next()) {
    const bool nearer = std::abs(frame->frame.time - *time) < std::abs(nearest->frame.time - *time);
    if (nearer) nearest = std::move(frame);
  }
  return std::move(*nearest);
}

/// A scene, simulated to `time` first if one is given.
Setup scene_at(const Scene& scene, const std::optional<double>& time) {
  Setup setup = realize_here(scene);
  if (!time) return setup;
  Simulation simulation(std::move(setup));
  simulation.stop_when(catch_interrupts());
  if (simulation.run_until(*time) == Simulation::Stop::interrupted) throw Interrupted();
  return {simulation.system(), simulation.frame()};
}

int draw_command(const DrawOptions& options) {
  const PictureFormat format = picture_format_of(options.out);
  if (options.time && !(*options.time >= 0 && std::isfinite(*options.time))) {
    throw Error(fmt::format("--time {}: it must be a finite time, 0 or more", *options.time));
  }
  StatePicture picture = options.picture;
  Setup setup;
  if (is_xyz(options.file)) {
    setup = frame_of(options.file, options.time);
  } else {
    const SceneFile file = read_scene(options.file);
    if (picture.title.empty()) picture.title = file.scene.title;
    setup = scene_at(file.scene, options.time);
  }
  write_file(options.out, picture_of_state(setup.system, setup.frame, picture, format));
  return kSuccess;
}

}  // namespace

void add_draw(CLI::App& app, Action& action) {
  CLI::App* command =
      add_command(app, "draw", "A picture of a scene", "carom draw scenes/gas.toml --time 2 -o gas.svg");
  const auto options = std::make_shared<DrawOptions>();
  command->add_option("FILE", options->file, "a scene, or an extended XYZ file (its last frame, or see --time)")
      ->required()
      ->type_name("");
  add_path(*command, "-o,--output", options->out, "FILE", "the picture: a name ending in .svg, .png or .pdf")
      ->required();
  add_number(*command, "--time", options->time,
             "simulate a scene to this time first; of a trajectory, draw the frame nearest to it");
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
