// What stands where in the HDF5 part of a checkpoint; docs/files.md says the same in words.
#include "checkpoint_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "carom/base/error.hpp"
#include "carom/io/scene_file.hpp"
#include "hdf5/group.hpp"
#include "hdf5/image.hpp"
#include "hdf5/trial.hpp"
#include "scene_reading.hpp"

namespace carom::io {
namespace {

constexpr std::size_t kMostText = std::size_t{1} << 24;
constexpr std::size_t kMostSums = 4096;
constexpr double kBytesPerNumber = 4;  // at least

void write_system(const Group& root, const System& system) {
  const Group group = root.create("system");
  group.write_attribute("box_size", std::vector<double>{system.box.size.x, system.box.size.y});
  group.write_attribute("boundary", std::vector<std::string>{std::string(name_of(system.box.boundary[0])),
                                                             std::string(name_of(system.box.boundary[1]))});
  group.write_attribute("restitution", system.physics.restitution);
  group.write_attribute("wall_restitution", system.physics.wall_restitution);
  group.write_attribute("t_c", system.physics.t_c);
  std::vector<double> radii;
  std::vector<double> masses;
  for (const Species& kind : system.species) {
    radii.push_back(kind.radius);
    masses.push_back(kind.mass);
  }
  group.write_array("species_radius", radii);
  group.write_array("species_mass", masses);
  group.write_array("species_of", system.species_of);
}

Boundary boundary_named(const std::string& name, const Group& group) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::reflecting, Boundary::open}) {
    if (name == name_of(boundary)) return boundary;
  }
  group.fail(fmt::format("there is no boundary '{}'", name));
}

System read_system(const Group& root, double most) {
  const Group group = root.below("system");
  System system;
  const std::vector<double> size = group.read_numbers("box_size", 2);
  system.box.size = {size[0], size[1]};
  const std::vector<std::string> boundary = group.read_texts("boundary", 2);
  if (boundary.size() != 2) group.fail("the box has no boundary");
  system.box.boundary = {boundary_named(boundary[0], group), boundary_named(boundary[1], group)};
  system.physics = {group.read_number("restitution"), group.read_number("wall_restitution"), group.read_number("t_c")};
  const std::size_t kinds = group.length_of("species_radius", most);
  const std::vector<double> radii = group.read_array<double>("species_radius", kinds);
  const std::vector<double> masses = group.read_array<double>("species_mass", kinds);
  const std::size_t disks = group.length_of("species_of", std::min(most, most_disks()));
  for (const std::uint32_t kind : group.read_array<std::uint32_t>("species_of", disks)) {
    if (kind >= kinds) group.fail("a disk is of a species that there is not");
    system.add_disk({radii[kind], masses[kind]});
  }
  return system;
}

void write_state(const Group& root, const State& state) {
  const Group group = root.create("state");
  group.write_attribute("window", state.clock.window);
  group.write_attribute("window_start", state.clock.start);
  group.write_attribute("window_length", state.clock.length);
  const Frame& disks = state.disks;
  group.write_array("x", disks.x);
  group.write_array("y", disks.y);
  group.write_array("vx", disks.vx);
  group.write_array("vy", disks.vy);
  group.write_array("winding_x", disks.winding_x);
  group.write_array("winding_y", disks.winding_y);
  group.write_array("last_contact", state.last_contact);
}

State read_state(const Group& root, std::size_t disks, bool elastic) {
  const Group group = root.below("state");
  State state;
  state.clock = {group.read_count("window"), group.read_number("window_start"), group.read_number("window_length")};
  Frame& frame = state.disks;
  frame.time = state.clock.start;
  frame.x = group.read_array<double>("x", disks);
  frame.y = group.read_array<double>("y", disks);
  frame.vx = group.read_array<double>("vx", disks);
  frame.vy = group.read_array<double>("vy", disks);
  frame.winding_x = group.read_array<std::int64_t>("winding_x", disks);
  frame.winding_y = group.read_array<std::int64_t>("winding_y", disks);
  state.last_contact = group.read_array<double>("last_contact", elastic ? 0 : disks);
  return state;
}

void write_books(const Group& root, const Books& books) {
  const Group group = root.create("books");
  group.write_attribute("collisions", books.collisions);
  group.write_attribute("wall_collisions", books.wall_collisions);
  group.write_attribute("ties", books.ties);
  group.write_attribute("collapses", books.collapses);
  group.write_attribute("largest_overlap", books.largest_overlap);
  group.write_array("events_of", books.events_of);
  group.write_array("virial_of", books.virial_of);
  group.write_array("wall_impulse_of", books.wall_impulse_of);
}

Books read_books(const Group& root, std::size_t disks, bool walls) {
  const Group group = root.below("books");
  Books books(0);
  books.collisions = group.read_count("collisions");
  books.wall_collisions = group.read_count("wall_collisions");
  books.ties = group.read_count("ties");
  books.collapses = group.read_count("collapses");
  books.largest_overlap = group.read_number("largest_overlap");
  books.events_of = group.read_array<std::uint64_t>("events_of", disks);
  books.virial_of = group.read_array<double>("virial_of", disks);
  books.wall_impulse_of = group.read_array<double>("wall_impulse_of", walls ? disks : 0);
  return books;
}

void write_measured(const Group& root, const Snapshot& snapshot) {
  const Group group = root.create("measured");
  group.write_attribute("from", snapshot.measure_from);
  group.write_attribute("started", std::uint64_t{snapshot.measured.started});
  group.write_attribute("start", snapshot.measured.start);
  group.write_attribute("kT_integral", snapshot.measured.kT_integral);
  group.write_attribute("energy_at_start", snapshot.initial.energy);
  group.write_attribute("momentum_at_start",
                        std::vector<double>{snapshot.initial.momentum.x, snapshot.initial.momentum.y});
  group.write_attribute("momentum_scale_at_start", snapshot.initial.momentum_scale);
}

void read_measured(const Group& root, Snapshot& snapshot) {
  const Group group = root.below("measured");
  snapshot.measure_from = group.read_number("from");
  snapshot.measured = {group.read_count("started") != 0, group.read_number("start"), group.read_number("kT_integral")};
  const std::vector<double> momentum = group.read_numbers("momentum_at_start", 2);
  snapshot.initial = {
      group.read_number("energy_at_start"), {momentum[0], momentum[1]}, group.read_number("momentum_scale_at_start")};
}

/// The [run] section of a scene holds the settings; a scene cannot say "until = 0", so that stands beside it.
void write_run(const Group& root, const Checkpoint& checkpoint) {
  const Group group = root.create("run");
  SceneFile file;
  file.scene.title = checkpoint.title;
  file.run = checkpoint.settings;
  file.run.until.reset();
  group.write_text("settings", to_toml(file));
  if (checkpoint.settings.until) group.write_attribute("until", *checkpoint.settings.until);
  group.write_attribute("scene_digest", checkpoint.scene_digest);
  group.write_attribute("quiet_windows", checkpoint.quiet_windows);
  group.write_attribute("wall_seconds", checkpoint.wall_seconds);
  group.write_attribute("frames", checkpoint.files.frames);
  group.write_attribute("trajectory_bytes", checkpoint.files.trajectory_bytes);
  group.write_attribute("log_bytes", checkpoint.files.log_bytes);
  if (checkpoint.files.log) group.write_attribute("log", *checkpoint.files.log);
}

void read_run(const Group& root, Checkpoint& checkpoint, const std::string& name) {
  const Group group = root.below("run");
  const ReadScene settings = read_toml(group.read_text("settings", kMostText), name + " (settings)");
  if (!settings.problems.empty()) throw Error(settings.problems);
  checkpoint.settings = settings.file.run;
  checkpoint.title = settings.file.scene.title;
  if (group.has_attribute("until")) checkpoint.settings.until = group.read_number("until");
  const auto& until = checkpoint.settings.until;
  if (until && !(*until >= 0 && *until <= kLatestTime)) group.fail("the time that the run is to end is out of range");
  checkpoint.scene_digest = group.read_text_attribute("scene_digest");
  checkpoint.quiet_windows = group.read_count("quiet_windows");
  checkpoint.wall_seconds = group.read_number("wall_seconds");
  if (!(checkpoint.wall_seconds >= 0)) group.fail("the time spent is out of range");
  checkpoint.files.frames = group.read_count("frames");
  checkpoint.files.trajectory_bytes = group.read_count("trajectory_bytes");
  checkpoint.files.log_bytes = group.read_count("log_bytes");
  if (group.has_attribute("log")) checkpoint.files.log = group.read_text_attribute("log");
}

/// Slashes would be groups; names of sums have no colons.
std::string without(char from, char to, std::string name) {
  std::replace(name.begin(), name.end(), from, to);
  return name;
}

void write_sums(const Group& root, const SavedSums& sums) {
  const Group group = root.create("sums");
  for (const auto& [name, numbers] : sums) {
    std::visit([&, &name = name](const auto& values) { group.write_array(without('/', ':', name), values); }, numbers);
  }
}

SavedSums read_sums(const Group& root, double most) {
  const Group group = root.below("sums");
  SavedSums sums;
  for (const std::string& name : group.names(kMostSums)) {
    ArrayShape shape;
    static_cast<void>(group.open_array(name, shape, most));
    if (shape.extents.size() != 1) group.fail("a sum is no row of numbers");
    const std::string key = without(':', '/', name);
    if (shape.integers) {
      sums[key] = group.read_array<std::int64_t>(name, shape.extents[0]);
    } else {
      sums[key] = group.read_array<double>(name, shape.extents[0]);
    }
  }
  return sums;
}

void write_start(const Group& root, const Frame& start) {
  const Group group = root.create("start");
  group.write_array("x", start.x);
  group.write_array("y", start.y);
  group.write_array("vx", start.vx);
  group.write_array("vy", start.vy);
}

Frame read_start(const Group& root, std::size_t disks) {
  const Group group = root.below("start");
  Frame start;
  start.resize(disks);
  start.x = group.read_array<double>("x", disks);
  start.y = group.read_array<double>("y", disks);
  start.vx = group.read_array<double>("vx", disks);
  start.vy = group.read_array<double>("vy", disks);
  return start;
}

std::size_t expected_size(const Checkpoint& checkpoint) {
  constexpr std::size_t kPerDisk = 9 * sizeof(double) + sizeof(std::uint32_t);
  return checkpoint.snapshot.system.size() * kPerDisk + (std::size_t{1} << 18);
}

}  // namespace

std::string checkpoint_image(const Checkpoint& checkpoint) {
  const InHdf5 inside;
  const std::string name = "checkpoint";
  const Handle file = create_image(name, expected_size(checkpoint));
  const Group root(file, name);
  write_system(root, checkpoint.snapshot.system);
  write_state(root, checkpoint.snapshot.state);
  write_books(root, checkpoint.snapshot.books);
  write_measured(root, checkpoint.snapshot);
  write_run(root, checkpoint);
  write_sums(root, checkpoint.sums);
  if (checkpoint.start) write_start(root, *checkpoint.start);
  return image_of(file, name);
}

namespace {

Checkpoint read_untried(std::string_view image, const std::string& name) {
  const InHdf5 inside;
  const Handle file = open_image(image, name);
  const Group root(file, name);
  const double most = static_cast<double>(image.size()) / kBytesPerNumber;
  Checkpoint checkpoint;
  Snapshot& snapshot = checkpoint.snapshot;
  snapshot.system = read_system(root, most);
  const std::size_t disks = snapshot.system.size();
  snapshot.state = read_state(root, disks, snapshot.system.physics.elastic());
  snapshot.books = read_books(root, disks, snapshot.system.box.has_walls());
  read_measured(root, snapshot);
  read_run(root, checkpoint, name);
  checkpoint.sums = read_sums(root, most);
  if (root.has("start")) checkpoint.start = read_start(root, disks);
  const std::vector<std::string> faults = faults_of(snapshot);
  if (!faults.empty()) throw Error("the checkpoint holds a state that no run can have reached: " + faults[0], {name});
  return checkpoint;
}

}  // namespace

Checkpoint read_checkpoint_image(std::string_view image, const std::string& name) {
  constexpr double kBytesPerSecond = 1e6;
  constexpr double kLeastSeconds = 10;
  try_in_child([&] { static_cast<void>(read_untried(image, name)); }, name,
               kLeastSeconds + static_cast<double>(image.size()) / kBytesPerSecond);
  return read_untried(image, name);
}

}  // namespace carom::io

bool carom::has_checkpoints() noexcept { return true; }
