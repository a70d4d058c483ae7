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
#include "carom/draw/movie.hpp"
#include "films.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#endif

namespace carom::program {
#ifdef CAROM_HAS_DRAW
namespace {

const std::map<std::string, ColourBy> kColours{{"species", ColourBy::species},
                                               {"speed", ColourBy::speed},
                                               {"psi6", ColourBy::psi6},
                                               {"density", ColourBy::density}};

struct DrawOptions {
  std::string out;
  std::optional<double> time;
  FilmOptions film;  ///< its file and picture are those of a single picture, too
  std::optional<double> frames_per_second;
};

/// The frame of a trajectory that is nearest in time, the last one if no time is given.
Setup frame_of(const std::string& path, const std::optional<double>& time) {
  const std::unique_ptr<TrajectoryReader> reader = open_trajectory(path);
  std::optional<Setup> nearest = reader->next();
  if (!nearest) throw Error("there are no frames", {path, 0, 0});
  while (std::optional<Setup> frame = reader->next()) {
    const bool nearer = !time || std::abs(frame->frame.time - *time) < std::abs(nearest->frame.time - *time);
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

int film_command(const DrawOptions& options) {
  if (!options.out.empty()) throw UsageError("give either -o or --movie");
  if (options.time) throw UsageError("--time is for a single picture: a film begins at the beginning");
  FilmOptions film = options.film;
  film.frames_per_second = options.frames_per_second.value_or(film.frames_per_second);
  if (!(film.frames_per_second > 0 && film.frames_per_second <= 1000)) {
    throw UsageError(fmt::format("--fps {}: it must lie above 0 and not above 1000", film.frames_per_second));
  }
  movie_format_of(film.out);
  make_film(film);
  return kSuccess;
}

int picture_command(const DrawOptions& options) {
  const FilmOptions& film = options.film;
  if (options.out.empty()) throw UsageError("which file? Give -o FILE, or --movie FILE for a film");
  if (film.until || film.every || options.frames_per_second) {
    throw UsageError("--until, --every and --fps are for films: they go with --movie FILE");
  }
  const PictureFormat format = picture_format_of(options.out);
  if (options.time && !(*options.time >= 0 && std::isfinite(*options.time))) {
    throw Error(fmt::format("--time {}: it must be a finite time, 0 or more", *options.time));
  }
  StatePicture picture = film.picture;
  Setup setup;
  if (is_trajectory(film.file)) {
    setup = frame_of(film.file, options.time);
  } else {
    const SceneFile file = read_scene(film.file);
    if (picture.title.empty()) picture.title = file.scene.title;
    setup = scene_at(file.scene, options.time);
  }
  write_file(options.out, picture_of_state(setup.system, setup.frame, picture, format));
  return kSuccess;
}

int draw_command(const DrawOptions& options) {
  return options.film.out.empty() ? picture_command(options) : film_command(options);
}

}  // namespace

void add_draw(CLI::App& app, Action& action) {
  CLI::App* command =
      add_command(app, "draw", "A picture of a scene", "carom draw scenes/gas.toml --time 2 -o gas.svg");
  const auto options = std::make_shared<DrawOptions>();
  FilmOptions& film = options->film;
  command->add_option("FILE", film.file, "a scene, or a trajectory (XYZ, H5MD; its last frame, or see --time)")
      ->required()
      ->type_name("");
  add_path(*command, "-o,--output", options->out, "FILE", "the picture: a name ending in .svg, .png or .pdf");
  add_path(*command, "--movie", film.out, "FILE",
           "a film instead, through ffmpeg: a name ending in .mp4 or .gif; of a trajectory its frames, of a scene from "
           "time 0 to --until");
  add_number(*command, "--until", film.until, "a film of a scene: simulate to this time (the scene's own)");
  add_number(*command, "--every", film.every, "a film of a scene: time between two pictures (a 250th of the whole)");
  add_number(*command, "--fps", options->frames_per_second, "a film: pictures per second (25)");
  add_number(*command, "--time", options->time,
             "simulate a scene to this time first; of a trajectory, draw the frame nearest to it");
  add_choice(*command, "--colour,--color", film.picture.colour, kColours,
             "by species, speed, psi6 (angle of the bond-orientational order) or density (of the Voronoi cells)");
  command->add_flag("--velocities", film.picture.velocities, "draw the velocities as arrows");
  add_number(*command, "--width", film.picture.width_px, "of the picture in pixels (1000)");
  command->add_option("--title", film.picture.title, "above the picture (the scene's)");
  command->add_flag("--quiet", film.quiet, "show no progress");
  command->callback([options, &action] { action = [options] { return draw_command(*options); }; });
}
#else
void add_draw(CLI::App& /*app*/, Action& /*action*/) {}  // built without pictures: there is no such command
#endif

}  // namespace carom::program
