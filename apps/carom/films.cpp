#include "films.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "carom/carom.hpp"
#include "carom/draw/movie.hpp"
#include "command.hpp"
#include "interrupt.hpp"
#include "progress.hpp"

namespace carom::program {
namespace {

constexpr double kUsualFrames = 250;
constexpr double kMostFrames = 100000;

using Visit = std::function<void(const System&, const Frame&)>;

/// Frames that can be gone through more than once.
class Frames {
 public:
  virtual ~Frames() = default;
  virtual void for_each(const Visit& visit) = 0;
  [[nodiscard]] virtual std::size_t count() = 0;
};

class FramesOfTrajectory final : public Frames {
 public:
  explicit FramesOfTrajectory(std::string path) : path_(std::move(path)) {}

  void for_each(const Visit& visit) override {
    const std::unique_ptr<TrajectoryReader> reader = open_trajectory(path_);
    while (const std::optional<Setup> setup = reader->next()) visit(setup->system, setup->frame);
  }

  std::size_t count() override {
    const std::unique_ptr<TrajectoryReader> reader = open_trajectory(path_);
    std::size_t frames = 0;
    while (reader->skip()) ++frames;
    return frames;
  }

 private:
  std::string path_;
};

class FramesOfScene final : public Frames {
 public:
  FramesOfScene(Setup setup, double until, double every) : setup_(std::move(setup)), every_(every) {
    const double steps = until / every;
    if (!(steps < kMostFrames))
      throw UsageError(fmt::format("a film has at most {:g} frames: give a longer --every", kMostFrames));
    count_ = static_cast<std::size_t>(steps + 1e-9) + 1;
  }

  void for_each(const Visit& visit) override {
    Simulation simulation(setup_);
    simulation.stop_when(catch_interrupts());
    for (std::size_t k = 0; k < count_; ++k) {
      if (simulation.run_until(static_cast<double>(k) * every_) == Simulation::Stop::interrupted) throw Interrupted();
      visit(simulation.system(), simulation.frame());
    }
  }

  std::size_t count() override { return count_; }

 private:
  Setup setup_;
  double every_;
  std::size_t count_ = 0;
};

std::unique_ptr<Frames> frames_of(const FilmOptions& options, StatePicture& picture) {
  if (is_trajectory(options.file)) {
    if (options.until || options.every) {
      throw UsageError(options.file + " is a trajectory: the film has its frames; --until and --every are for scenes");
    }
    return std::make_unique<FramesOfTrajectory>(options.file);
  }
  const SceneFile file = read_scene(options.file);
  const std::optional<double> until = options.until ? options.until : file.run.until;
  if (!until) throw UsageError(options.file + ": when should the film end? Give --until TIME");
  if (!(*until > 0 && *until <= kLatestTime))
    throw UsageError(fmt::format("--until {}: it must be a time greater than 0", *until));
  const double every = options.every.value_or(*until / kUsualFrames);
  if (!(every > 0)) throw UsageError(fmt::format("--every {}: it must be a time greater than 0", every));
  if (picture.title.empty()) picture.title = file.scene.title;
  return std::make_unique<FramesOfScene>(realize_here(file.scene), *until, every);
}

void stop_if_interrupted() {
  if (catch_interrupts().load(std::memory_order_relaxed)) throw Interrupted();
}

/// What all pictures share is known only after all frames were seen; where boxes have walls or seams and colours are
/// those of species, it does not matter.
SharedScale scale_of(Frames& frames, const StatePicture& picture) {
  SharedScale scale;
  const bool by_species = picture.colour == ColourBy::species || picture.colour == ColourBy::psi6;
  bool enough = false;
  frames.for_each([&](const System& system, const Frame& frame) {
    stop_if_interrupted();
    if (enough) return;
    include_in_scale(system, frame, picture, scale);
    const bool open = system.box.boundary[0] == Boundary::open || system.box.boundary[1] == Boundary::open;
    enough = by_species && !open && !picture.velocities;
  });
  return scale;
}

}  // namespace

bool is_trajectory(const std::string& path) { return path.ends_with(".xyz") || is_hdf5_file(path); }

void make_film(const FilmOptions& options) {
  StatePicture picture = options.picture;
  const std::unique_ptr<Frames> frames = frames_of(options, picture);
  const std::size_t count = frames->count();
  if (count == 0) throw Error("there are no frames", {options.file, 0, 0});
  catch_interrupts();
  Movie movie(options.out, options.frames_per_second);
  picture.shared = scale_of(*frames, picture);
  ProgressBar bar(!options.quiet);
  std::size_t drawn = 0;
  frames->for_each([&](const System& system, const Frame& frame) {
    stop_if_interrupted();
    movie.add(picture_of_state(system, frame, picture, PictureFormat::png));
    ++drawn;
    bar.show({static_cast<double>(drawn) / static_cast<double>(count), frame.time, 0,
              fmt::format("picture {} of {}", drawn, count)});
  });
  stop_if_interrupted();
  movie.finish();
}

}  // namespace carom::program
