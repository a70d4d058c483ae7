#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "carom/base/error.hpp"
#include "h5md.hpp"
#include "hdf5/group.hpp"
#include "hdf5/image.hpp"
#include "hdf5/trial.hpp"

namespace carom::io {
namespace {

/// No compression that HDF5 offers makes more of a byte than this (deflate: 1032).
constexpr double kMostNumbersPerByte = 1100;

Boundary boundary_named(const std::string& name, const Group& group) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::reflecting, Boundary::open}) {
    if (name == name_of(boundary)) return boundary;
  }
  if (name == "none") return Boundary::open;
  group.fail(fmt::format("there is no boundary '{}'", name));
}

std::array<Boundary, 2> boundaries_in(const Group& group) {
  const std::vector<std::string> names = group.read_texts("boundary", 2);
  if (names.size() != 2) group.fail("a box of two dimensions needs two boundaries");
  return {boundary_named(names[0], group), boundary_named(names[1], group)};
}

/// A handle of the first group of particles, "all" if there is one of that name.
Group particles_in(const Group& root) {
  constexpr std::size_t kMostGroups = 1000;
  const Group particles = root.below("particles");
  if (particles.has("all")) return particles.below("all");
  for (const std::string& name : particles.names(kMostGroups)) {
    if (particles.has(name + "/position")) return particles.below(name);
  }
  root.fail("no group of particles has positions");
}

/// One element that changes with time: a row for every frame.
struct Element {
  Handle data;
  ArrayShape shape;

  [[nodiscard]] bool there() const noexcept { return data.open(); }
  [[nodiscard]] hsize_t frames() const noexcept { return shape.extents[0]; }
};

class H5mdReader final : public TrajectoryReader {
 public:
  /// `bytes`: how large the file is.
  H5mdReader(Handle file, const std::string& name, double bytes)
      : file_(std::move(file)), root_(file_, name), all_(particles_in(root_)), most_(bytes * kMostNumbersPerByte) {
    position_ = element("position", 2);
    velocity_ = element("velocity", 2);
    if (all_.has("image")) image_ = element("image", 2);
    if (all_.has("id")) id_ = element("id", 1);
    time_ = times();
    frames_ = time_.frames();
    for (const Element* each : {&position_, &velocity_, &image_, &id_}) {
      if (each->there()) frames_ = std::min(frames_, each->frames());
    }
    read_system();
  }

  std::optional<Setup> next() override {
    const InHdf5 inside;
    if (next_ >= frames_) return std::nullopt;
    Setup setup{system_, {}};
    Frame& frame = setup.frame;
    frame.time = time_at(next_);
    read_pairs(position_, frame.x, frame.y);
    read_pairs(velocity_, frame.vx, frame.vy);
    frame.winding_x.resize(disks_);
    frame.winding_y.resize(disks_);
    if (image_.there()) read_pairs(image_, frame.winding_x, frame.winding_y);
    if (id_.there()) put_in_order(setup);
    ++next_;
    return setup;
  }

  std::optional<FrameHeader> skip() override {
    const InHdf5 inside;
    if (next_ >= frames_) return std::nullopt;
    return FrameHeader{disks_, time_at(next_++)};
  }

  [[nodiscard]] bool cut_off() const noexcept override { return false; }

 private:
  /// The values of an element, which must have the shape (frames, disks, width).
  Element element(const std::string& name, hsize_t width) {
    Element found;
    const std::string path = name + "/value";
    found.data = all_.open_array(path, found.shape, std::numeric_limits<double>::infinity());
    const std::vector<hsize_t>& extents = found.shape.extents;
    const bool fits = extents.size() == (width == 1 ? 2 : 3) && (width == 1 || extents[2] == width);
    if (!fits) all_.fail(fmt::format("'{}' has not the shape (frames, disks, {})", name, width));
    if (disks_ == 0) {
      const double disks = static_cast<double>(extents[1]);
      if (disks == 0 || disks > std::min(most_, most_disks())) {
        all_.fail(fmt::format("{} disks: there cannot be so many in this file", disks));
      }
      disks_ = extents[1];
    }
    if (extents[1] != disks_) all_.fail(fmt::format("'{}' is of another number of disks", name));
    return found;
  }

  Element times() {
    Element found;
    found.data = all_.open_array("position/time", found.shape, std::numeric_limits<double>::infinity());
    if (found.shape.extents.size() != 1) all_.fail("'position/time' is not a row of numbers");
    return found;
  }

  void read_system() {
    const Group box = all_.below("box");
    if (box.read_count("dimension") != 2) box.fail("the box has not two dimensions");
    const Group described = root_.has("parameters/carom") ? root_.below("parameters/carom") : root_.below("particles");
    const bool ours = described.has_attribute("boundary");
    system_.box.boundary = boundaries_in(ours ? described : box);
    if (box.has("edges")) {
      const std::vector<double> edges = box.read_array<double>("edges", 2);
      system_.box.size = {edges[0], edges[1]};
    }
    if (ours) {
      system_.physics = {described.read_number("restitution"), described.read_number("wall_restitution"),
                         described.read_number("t_c")};
    }
    if (!all_.has("radius")) all_.fail("'radius' is missing: how large are the disks?");
    const std::vector<double> radius = all_.read_array<double>("radius", disks_);
    const std::vector<double> mass =
        all_.has("mass") ? all_.read_array<double>("mass", disks_) : std::vector<double>(disks_, 1.0);
    for (std::size_t k = 0; k < disks_; ++k) system_.add_disk({radius[k], mass[k]});
  }

  template <typename Number>
  std::vector<Number> row(const Element& element, std::size_t width) const {
    const Handle where(H5Dget_space(element.data.id()), H5Sclose);
    std::vector<hsize_t> offset(element.shape.extents.size(), 0);
    std::vector<hsize_t> count = element.shape.extents;
    offset[0] = next_;
    count[0] = 1;
    const hsize_t numbers = disks_ * width;
    const Handle what(H5Screate_simple(1, &numbers, nullptr), H5Sclose);
    std::vector<Number> values(numbers);
    require(
        H5Sselect_hyperslab(where.id(), H5S_SELECT_SET, offset.data(), nullptr, count.data(), nullptr) >= 0 &&
            H5Dread(element.data.id(), memory_type<Number>(), what.id(), where.id(), H5P_DEFAULT, values.data()) >= 0,
        all_.file_name(), fmt::format("frame {} cannot be read", next_));
    return values;
  }

  template <typename Number>
  void read_pairs(const Element& element, std::vector<Number>& x, std::vector<Number>& y) const {
    const std::vector<Number> pairs = row<Number>(element, 2);
    x.resize(disks_);
    y.resize(disks_);
    for (std::size_t k = 0; k < disks_; ++k) {
      x[k] = pairs[2 * k];
      y[k] = pairs[2 * k + 1];
    }
  }

  double time_at(hsize_t index) const {
    const hsize_t one = 1;
    const Handle where(H5Dget_space(time_.data.id()), H5Sclose);
    const Handle what(H5Screate_simple(1, &one, nullptr), H5Sclose);
    double time = 0;
    require(H5Sselect_hyperslab(where.id(), H5S_SELECT_SET, &index, nullptr, &one, nullptr) >= 0 &&
                H5Dread(time_.data.id(), H5T_NATIVE_DOUBLE, what.id(), where.id(), H5P_DEFAULT, &time) >= 0,
            all_.file_name(), fmt::format("the time of frame {} cannot be read", index));
    return time;
  }

  /// Other programs may write disks in any order; ids say which is which.
  void put_in_order(Setup& setup) const {
    const std::vector<std::int64_t> ids = row<std::int64_t>(id_, 1);
    if (std::is_sorted(ids.begin(), ids.end())) return;
    std::vector<std::size_t> order(disks_);
    for (std::size_t k = 0; k < disks_; ++k) order[k] = k;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
    const Setup found = std::exchange(setup, {});
    setup.system.box = found.system.box;
    setup.system.physics = found.system.physics;
    setup.frame.time = found.frame.time;
    for (const std::size_t k : order) {
      setup.system.add_disk(found.system.species_of_disk(k));
      setup.frame.add_disk(found.frame.position(k), found.frame.velocity(k));
      setup.frame.winding_x.back() = found.frame.winding_x[k];
      setup.frame.winding_y.back() = found.frame.winding_y[k];
    }
  }

  Handle file_;
  Group root_;
  Group all_;
  double most_;
  std::size_t disks_ = 0;
  Element position_, velocity_, image_, id_, time_;
  System system_;
  hsize_t frames_ = 0;
  hsize_t next_ = 0;
};

std::unique_ptr<TrajectoryReader> open_untried(const std::string& path, double bytes) {
  const InHdf5 inside;
  prepare_hdf5();
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  return std::make_unique<H5mdReader>(opened(id, H5Fclose, path, "is not a sound HDF5 file"), path, bytes);
}

std::unique_ptr<TrajectoryReader> open_untried(std::string_view image, const std::string& name) {
  const InHdf5 inside;
  return std::make_unique<H5mdReader>(open_image(image, name), name, static_cast<double>(image.size()));
}

/// Large files are tried in part: all times and the first frame.
void try_frames(TrajectoryReader& reader, double bytes) {
  constexpr double kReadInFull = 64e6;
  static_cast<void>(reader.next());
  while (bytes < kReadInFull && reader.next()) {
  }
  while (reader.skip()) {
  }
}

double patience(double bytes) noexcept {
  constexpr double kBytesPerSecond = 1e6;
  constexpr double kLeastSeconds = 10;
  return kLeastSeconds + bytes / kBytesPerSecond;
}

}  // namespace

std::unique_ptr<TrajectoryReader> open_h5md(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) throw Error("cannot be read", {path});
  const auto bytes = static_cast<double>(about.st_size);
  try_in_child([&] { try_frames(*open_untried(path, bytes), bytes); }, path, patience(bytes));
  return open_untried(path, bytes);
}

std::unique_ptr<TrajectoryReader> open_h5md_image(std::string_view image, const std::string& name) {
  const auto bytes = static_cast<double>(image.size());
  try_in_child([&] { try_frames(*open_untried(image, name), bytes); }, name, patience(bytes));
  return open_untried(image, name);
}

}  // namespace carom::io
