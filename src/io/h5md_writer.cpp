#include <algorithm>
#include <array>
#include <optional>

#include "carom/base/error.hpp"
#include "h5md.hpp"
#include "hdf5/group.hpp"
#include "hdf5/growing_file.hpp"
#include "hdf5/rows.hpp"

namespace carom::io {
namespace {

using Texts = std::vector<std::string>;

void link(const Group& from, const std::string& name, const Group& to) {
  require(H5Lcreate_hard(from.id(), name.c_str(), to.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0,
          from.file_name(), "cannot be written");
}

void write_about(const Group& root) {
  const Group about = root.create("h5md");
  about.write_attribute("version", std::vector<std::int64_t>{1, 1});
  about.create("author").write_attribute("name", std::string_view("carom"));
  const Group creator = about.create("creator");
  creator.write_attribute("name", std::string_view("carom"));
  creator.write_attribute("version", std::string_view(CAROM_VERSION));
}

void write_box(const Group& all, const Box& box) {
  const Group group = all.create("box");
  group.write_attribute("dimension", std::uint64_t{2});
  Texts boundary;
  for (int axis = 0; axis < 2; ++axis) boundary.emplace_back(box.periodic(axis) ? "periodic" : "none");
  group.write_attribute("boundary", boundary);
  group.write_array("edges", std::vector<double>{box.size.x, box.size.y});
}

/// What H5MD has no words for: walls, and how disks collide.
void write_parameters(const Group& root, const System& system) {
  const Group group = root.create("parameters").create("carom");
  group.write_attribute(
      "boundary", Texts{std::string(name_of(system.box.boundary[0])), std::string(name_of(system.box.boundary[1]))});
  group.write_attribute("restitution", system.physics.restitution);
  group.write_attribute("wall_restitution", system.physics.wall_restitution);
  group.write_attribute("t_c", system.physics.t_c);
}

/// What does not change with time.
void write_constants(const Group& all, const System& system) {
  std::vector<double> radius;
  std::vector<double> mass;
  std::vector<std::int64_t> species;
  for (std::size_t k = 0; k < system.size(); ++k) {
    radius.push_back(system.radius(k));
    mass.push_back(system.mass(k));
    species.push_back(system.species_of[k]);
  }
  all.write_array("species", species);
  all.write_array("mass", mass);
  all.write_array("radius", radius);
}

template <typename Number>
std::vector<Number> paired(const std::vector<Number>& x, const std::vector<Number>& y) {
  std::vector<Number> pairs(2 * x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    pairs[2 * k] = x[k];
    pairs[2 * k + 1] = y[k];
  }
  return pairs;
}

/// The datasets that grow.
struct Columns {
  Rows position, velocity, image, id, kinetic_energy, temperature, step, time;
  static constexpr std::size_t kCount = 8;
  /// In the order in which they are written: a time is there only when all that belongs to it is.
  [[nodiscard]] std::array<Rows*, kCount> all() {
    return {&position, &velocity, &image, &id, &kinetic_energy, &temperature, &step, &time};
  }
};

/// An element or observable: a group with value, step and time, the latter two shared by all.
template <typename Number>
Rows create_element(const Group& parent, const std::string& name, std::vector<hsize_t> row, const Group& clock) {
  const Group element = parent.create(name);
  Rows rows = Rows::create<Number>(element, "value", std::move(row));
  link(clock, "step", element);
  link(clock, "time", element);
  return rows;
}

Columns create_columns(const Group& root, const Group& all, const System& system) {
  const hsize_t disks = system.size();
  const Group observables = root.create("observables");
  const Group first = all.create("position");
  Rows position = Rows::create<double>(first, "value", {disks, 2});
  Rows step = Rows::create<std::int64_t>(first, "step", {});
  Rows time = Rows::create<double>(first, "time", {});
  return {std::move(position),
          create_element<double>(all, "velocity", {disks, 2}, first),
          create_element<std::int64_t>(all, "image", {disks, 2}, first),
          create_element<std::int64_t>(all, "id", {disks}, first),
          create_element<double>(observables, "kinetic_energy", {}, first),
          create_element<double>(observables, "temperature", {}, first),
          std::move(step),
          std::move(time)};
}

Columns open_columns(const Group& root, std::size_t disks) {
  const auto rows = [&](const char* path, std::vector<hsize_t> row) { return Rows::open(root, path, std::move(row)); };
  return {rows("particles/all/position/value", {disks, 2}), rows("particles/all/velocity/value", {disks, 2}),
          rows("particles/all/image/value", {disks, 2}),    rows("particles/all/id/value", {disks}),
          rows("observables/kinetic_energy/value", {}),     rows("observables/temperature/value", {}),
          rows("particles/all/position/step", {}),          rows("particles/all/position/time", {})};
}

class H5mdWriter final : public TrajectoryWriter {
 public:
  using Start = GrowingFile::Start;

  H5mdWriter(const std::string& path, const System& system) : disk_(path, Start::create), path_(path) {
    with_reason([&] {
      file_ = disk_.open(Start::create);
      lay_out(system);
      begin_growing();
      disk_.put_in_place();
    });
  }

  H5mdWriter(const std::string& path, const System& system, const TrajectoryLength& kept)
      : disk_(path, Start::go_on), path_(path) {
    with_reason([&] {
      file_ = disk_.open(Start::go_on);
      columns_.emplace(open_columns(Group(file_, path_), system.size()));
      require_frames(kept.frames);
      begin_growing();
    });
  }

  ~H5mdWriter() override {
    try {
      close();
    } catch (...) {
      // Nobody is left to tell: close() is to be called before.
    }
  }

  void append(const System& system, const Frame& frame) override {
    with_reason([&] {
      append_rows(system, frame);
      flush();
    });
  }

  [[nodiscard]] TrajectoryLength length() const noexcept override { return {columns_->time.count(), 0}; }

  void cut_to(const TrajectoryLength& length) override {
    with_reason([&] {
      const auto columns = columns_->all();
      std::for_each(columns.rbegin(), columns.rend(), [&](Rows* column) { column->cut_to(length.frames); });
      flush();
    });
  }

  void sync() override { disk_.sync(); }

  void close() override {
    if (!file_.open()) return;
    const InHdf5 inside;
    columns_.reset();
    disk_.prepare_closing();
    const bool closed = file_.close();
    disk_.throw_if_failed();
    require(closed, path_, "cannot be written");
  }

 private:
  /// The system's reason for a failure tells more than what the library made of it.
  template <typename Action>
  void with_reason(const Action& action) const {
    const InHdf5 inside;
    try {
      action();
    } catch (const Error&) {
      disk_.throw_if_failed();
      throw;
    }
  }

  void lay_out(const System& system) {
    const Group root(file_, path_);
    write_about(root);
    write_parameters(root, system);
    const Group all = root.create("particles").create("all");
    write_box(all, system.box);
    write_constants(all, system);
    columns_.emplace(create_columns(root, all, system));
  }

  void require_frames(std::uint64_t frames) {
    for (const Rows* column : columns_->all()) {
      if (column->count() >= frames) continue;
      throw Error("is shorter than it was: " + std::to_string(column->count()) + " frames, of which " +
                      std::to_string(frames) + " should stay",
                  {path_});
    }
  }

  void append_rows(const System& system, const Frame& frame) {
    std::vector<std::int64_t> ids(frame.size());
    for (std::size_t k = 0; k < ids.size(); ++k) ids[k] = static_cast<std::int64_t>(k);
    const auto number = [](Rows& rows, auto value) { rows.append(std::span<const decltype(value)>(&value, 1)); };
    columns_->position.append<double>(paired(frame.x, frame.y));
    columns_->velocity.append<double>(paired(frame.vx, frame.vy));
    columns_->image.append<std::int64_t>(paired(frame.winding_x, frame.winding_y));
    columns_->id.append<std::int64_t>(ids);
    number(columns_->kinetic_energy, kinetic_energy(system, frame));
    number(columns_->temperature, temperature(system, frame));
    number(columns_->step, static_cast<std::int64_t>(columns_->step.count()));
    number(columns_->time, frame.time);
  }

  /// From here on every write leaves the file whole.
  void begin_growing() {
    require(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0 && H5Fstart_swmr_write(file_.id()) >= 0, path_,
            "cannot be written");
    disk_.seal();
  }

  void flush() {
    disk_.seal();
    for (Rows* column : columns_->all()) column->flush();
    disk_.throw_if_failed();
  }

  GrowingFile disk_;
  std::string path_;
  Handle file_;
  std::optional<Columns> columns_;
};

}  // namespace

std::unique_ptr<TrajectoryWriter> create_h5md(const std::string& path, const System& system) {
  return std::make_unique<H5mdWriter>(path, system);
}

std::unique_ptr<TrajectoryWriter> continue_h5md(const std::string& path, const System& system,
                                                const TrajectoryLength& kept) {
  static_cast<void>(open_h5md(path));  // refuses what HDF5 would crash on
  return std::make_unique<H5mdWriter>(path, system, kept);
}

}  // namespace carom::io
