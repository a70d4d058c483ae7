// carom convert: scenes, states and trajectories from one format into another, told by the names' endings.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "carom/carom.hpp"
#include "command.hpp"
#include "options.hpp"

namespace carom::program {
namespace {

namespace fs = std::filesystem;

struct ConvertOptions {
  std::string in;
  std::string out;
  std::optional<double> time;
};

std::string ending_of(const std::string& path) { return fs::path(path).extension().string(); }

/// Frames of the input one after another: those of a trajectory, or the one of a scene or checkpoint.
class Frames {
 public:
  explicit Frames(const std::string& path) : path_(path) {
    std::error_code unknown;
    const bool regular = path != "-" && fs::is_regular_file(path, unknown);
    const std::string ending = ending_of(path);
    const bool trajectory = regular && (is_hdf5_file(path) || ending == ".xyz" || ending == ".extxyz");
    if (ending == ".csv") throw Error("a table of frames does not tell the box: nothing is converted from it", {path});
    if (trajectory) {
      reader_ = open_trajectory(path);
    } else if (is_checkpoint_file(path)) {
      Checkpoint checkpoint = read_checkpoint(path);
      run_ = checkpoint.settings;
      title_ = std::move(checkpoint.title);
      single_ = {std::move(checkpoint.snapshot.system), std::move(checkpoint.snapshot.state.disks)};
    } else {
      SceneFile file = read_scene(path);
      run_ = std::move(file.run);
      title_ = file.scene.title;
      single_ = realize_here(file.scene);
    }
  }

  std::optional<Setup> next() {
    if (!reader_) return std::exchange(single_, std::nullopt);
    std::optional<Setup> setup = reader_->next();
    if (!setup && reader_->cut_off()) tell(path_ + ": the last frame is cut off and left out");
    return setup;
  }

  /// The last frame, or the last one that is not later than `time`.
  Setup pick(const std::optional<double>& time) {
    std::optional<Setup> picked;
    while (std::optional<Setup> setup = next()) {
      if (!time || setup->frame.time <= *time) picked = std::move(setup);
    }
    if (!picked && time) throw Error(fmt::format("there is no frame at or before time {}", *time), {path_});
    if (!picked) throw Error("there is no frame in this file", {path_});
    return std::move(*picked);
  }

  [[nodiscard]] const RunSettings& run() const noexcept { return run_; }
  [[nodiscard]] const std::string& title() const noexcept { return title_; }

 private:
  std::string path_;
  std::unique_ptr<TrajectoryReader> reader_;
  std::optional<Setup> single_;
  RunSettings run_;
  std::string title_;
};

/// A file that takes its name when it is whole.
class NewFile {
 public:
  explicit NewFile(const std::string& path) : path_(path) {
    std::error_code not_there;
    if (const fs::path followed = fs::canonical(path, not_there); !not_there)
      path_ = followed.string();  // a link's file
    new_path_ = fmt::format("{}.part-{}", path_, getpid());
  }
  ~NewFile() {
    std::error_code ignored;
    if (!in_place_) fs::remove(new_path_, ignored);
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  [[nodiscard]] const std::string& name() const noexcept { return new_path_; }
  void put_in_place() {
    std::error_code error;
    fs::rename(new_path_, path_, error);
    if (error) throw Error("cannot be written: " + error.message(), {path_});
    in_place_ = true;
  }

 private:
  std::string path_;
  std::string new_path_;
  bool in_place_ = false;
};

bool same_disks(const System& a, const System& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a.species_of_disk(k) != b.species_of_disk(k)) return false;
  }
  return true;
}

/// All frames into a trajectory.
void write_trajectory(Frames& frames, const ConvertOptions& options, TrajectoryFormat format) {
  std::optional<Setup> setup = options.time ? frames.pick(options.time) : frames.next();
  if (!setup) throw Error("there is no frame in this file", {options.in});
  const System first = setup->system;
  NewFile file(options.out);
  const std::unique_ptr<TrajectoryWriter> writer = create_trajectory(file.name(), format, first);
  for (; setup; setup = options.time ? std::nullopt : frames.next()) {
    if (format == TrajectoryFormat::h5md && !same_disks(setup->system, first)) {
      throw Error("the disks change from frame to frame: an H5MD trajectory cannot hold that", {options.in});
    }
    writer->append(setup->system, setup->frame);
  }
  writer->sync();
  writer->close();
  file.put_in_place();
}

void write_csv(Frames& frames, const ConvertOptions& options) {
  NewFile file(options.out);
  OutputStream stream(file.name());
  stream.write(frames_csv_head());
  std::optional<Setup> setup = options.time ? frames.pick(options.time) : frames.next();
  if (!setup) throw Error("there is no frame in this file", {options.in});
  for (; setup; setup = options.time ? std::nullopt : frames.next()) {
    stream.write(frame_csv(setup->system, setup->frame));
  }
  stream.sync();
  stream.close();
  file.put_in_place();
}

void write_toml(Frames& frames, const ConvertOptions& options) {
  const Setup setup = frames.pick(options.time);
  write_file(options.out, to_toml({explicit_scene(setup, frames.title()), frames.run()}));
}

/// What observables know before anything has happened.
void add_start(Checkpoint& checkpoint, const Setup& setup) {
  if (checkpoint.settings.observe.empty()) return;
  ObservableSet observables(checkpoint.settings.observe, {setup.system, setup.frame});
  observables.exchange({checkpoint.sums, SumsExchange::Direction::save});
  checkpoint.start = setup.frame;
}

/// A run that stands at time 0 and has not begun.
void write_start(Frames& frames, const ConvertOptions& options) {
  Setup setup = frames.pick(options.time);
  setup.frame.time = 0;
  Checkpoint checkpoint;
  checkpoint.scene_digest = digest(setup.system, setup.frame);
  checkpoint.settings = frames.run();
  checkpoint.title = frames.title();
  add_start(checkpoint, setup);
  Simulation simulation(std::move(setup));
  simulation.measure_from(checkpoint.settings.equilibrate);
  checkpoint.snapshot = simulation.snapshot();
  write_checkpoint(options.out, {}, checkpoint);
}

int convert_command(const ConvertOptions& options) {
  const std::string ending = ending_of(options.out);
  const bool known = ending == ".toml" || ending == ".xyz" || ending == ".extxyz" || ending == ".h5md" ||
                     ending == ".csv" || ending == ".h5";
  if (!known) {
    throw Error(
        fmt::format("cannot convert to {}: give a name that ends in .toml, .xyz, .h5md, .csv or .h5", options.out));
  }
  Frames frames(options.in);
  if (ending == ".toml") {
    write_toml(frames, options);
  } else if (ending == ".csv") {
    write_csv(frames, options);
  } else if (ending == ".h5") {
    write_start(frames, options);
  } else {
    write_trajectory(frames, options, ending == ".h5md" ? TrajectoryFormat::h5md : TrajectoryFormat::xyz);
  }
  return kSuccess;
}

}  // namespace

void add_convert(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "convert", "Rewrite a scene, state or trajectory in another format",
                                  "carom convert scenes/gas.toml gas.xyz");
  const auto options = std::make_shared<ConvertOptions>();
  command->add_option("IN", options->in, "TOML, algs4 text, extended XYZ, H5MD or a checkpoint")
      ->required()
      ->type_name("");
  command
      ->add_option("OUT", options->out,
                   "a name ending in .xyz, .h5md or .csv (all frames), .toml or .h5 (the last frame as\n"
                   "a scene, or as a checkpoint at time 0)")
      ->required()
      ->type_name("");
  add_number(*command, "--time", options->time, "take one frame: the last one that is not later than this time");
  command->callback([options, &action] { action = [options] { return convert_command(*options); }; });
}

}  // namespace carom::program
