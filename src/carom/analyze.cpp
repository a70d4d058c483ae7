#include "carom/carom/analyze.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "carom/base/error.hpp"
#include "carom/io/file.hpp"
#include "carom/io/trajectory.hpp"
#include "carom/observe/observable_set.hpp"

namespace carom {
namespace {

namespace fs = std::filesystem;

/// The trajectory's file, if `path` is a run's directory.
std::string trajectory_in(const std::string& path) {
  std::error_code ignored;
  if (path == "-" || !fs::is_directory(path, ignored)) return path;
  for (const char* const name : {"trajectory.xyz", "trajectory.h5md"}) {
    std::string file = (fs::path(path) / name).string();
    if (fs::exists(file, ignored)) return file;
  }
  throw Error("holds no trajectory: run with --trajectory xyz --every DT", {path});
}

/// The frames of a saved trajectory, one after another.
class SavedFrames {
 public:
  explicit SavedFrames(const std::string& path) : reader_(open_trajectory(path)), name_(display_name(path)) {}

  /// The next frame with its system, or nothing at the end.
  std::optional<Setup> next() {
    std::optional<Setup> frame = reader_->next();
    if (frame) ++number_;
    return frame;
  }

  /// Whether the file ended in the middle of a frame, which next() has left out.
  [[nodiscard]] bool cut_off() const noexcept { return reader_->cut_off(); }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(fmt::format("frame {}: {}", number_, reason), {name_});
  }

 private:
  std::unique_ptr<TrajectoryReader> reader_;
  std::string name_;
  std::uint64_t number_ = 0;
};

/// Why two frames cannot be of one trajectory; empty if they can.
std::string difference(const Setup& first, const Setup& other) {
  if (other.system.size() != first.system.size()) {
    return fmt::format("it has {} disks, the first one has {}", other.system.size(), first.system.size());
  }
  const Box& box = first.system.box;
  if (other.system.box.size != box.size || other.system.box.boundary != box.boundary) {
    return "its box is not that of the first one";
  }
  for (std::size_t k = 0; k < first.system.size(); ++k) {
    if (other.system.species_of_disk(k) != first.system.species_of_disk(k)) {
      return fmt::format("disk {} has another radius or mass than in the first one", k);
    }
  }
  return {};
}

/// Counts windings from frame to frame.
class Unwinding {
 public:
  explicit Unwinding(const Setup& first) : box_(first.system.box), last_(first.frame) {}

  void unwind(Frame& frame) {
    const double duration = frame.time - last_.time;
    for (std::size_t k = 0; k < frame.size(); ++k) {
      if (box_.periodic(0)) {
        frame.winding_x[k] = wound(frame.x[k], last_.x[k], last_.winding_x[k], box_.size.x);
        note(last_.vx[k], duration, box_.size.x);
      }
      if (box_.periodic(1)) {
        frame.winding_y[k] = wound(frame.y[k], last_.y[k], last_.winding_y[k], box_.size.y);
        note(last_.vy[k], duration, box_.size.y);
      }
    }
    last_ = frame;
  }

  /// Whether some disk could have gone half a box between two frames, at its speed at the first of them.
  [[nodiscard]] bool doubtful() const noexcept { return doubtful_; }

 private:
  static std::int64_t wound(double now, double before, std::int64_t winding, double period) {
    return winding - static_cast<std::int64_t>(std::rint((now - before) / period));
  }
  void note(double velocity, double duration, double period) {
    doubtful_ = doubtful_ || std::abs(velocity) * duration > 0.5 * period;
  }

  Box box_;
  Frame last_;
  bool doubtful_ = false;
};

/// Every observable that these frames have: an open plane has no profile, a single disk no temperature.
std::vector<ObserveSpec> all_for(const Subject& subject) {
  std::vector<ObserveSpec> specs;
  for (const std::string& name : observables_of_frames()) {
    try {
      make_observable({.name = name}, subject);
      specs.push_back({.name = name});
    } catch (const Error&) {
      continue;
    }
  }
  return specs;
}

}  // namespace

std::vector<std::string> observables_of_frames() {
  std::vector<std::string> names;
  for (const ObservableKind& kind : observable_kinds()) {
    if (kind.from_frames) names.emplace_back(kind.name);
  }
  return names;
}

std::vector<Measurement> analyze(const std::string& path, const std::vector<ObserveSpec>& specs) {
  const std::string file = trajectory_in(path);
  const bool knows_windings = is_hdf5_file(file);
  SavedFrames frames(file);
  const std::optional<Setup> first = frames.next();
  if (!first) frames.refuse("there is none in this file");
  std::optional<Setup> next = frames.next();
  if (next && !(next->frame.time > first->frame.time)) {
    frames.refuse(
        fmt::format("its time {} is not after that of the frame before, {}", next->frame.time, first->frame.time));
  }
  const double spacing = next ? next->frame.time - first->frame.time : 1;
  const Subject subject{first->system, first->frame, spacing};
  ObservableSet set(specs.empty() ? all_for(subject) : specs, subject);
  set.on_frame(first->system, first->frame);

  Unwinding unwinding(*first);
  double time = first->frame.time;
  for (; next; next = frames.next()) {
    const std::string reason = difference(*first, *next);
    if (!reason.empty()) frames.refuse(reason);
    if (!(next->frame.time > time)) {
      frames.refuse(fmt::format("its time {} is not after that of the frame before, {}", next->frame.time, time));
    }
    time = next->frame.time;
    if (!knows_windings) unwinding.unwind(next->frame);
    set.on_frame(first->system, next->frame);
  }
  std::vector<Measurement> found = set.results();
  for (Measurement& measurement : found) {
    if (frames.cut_off())
      measurement.warnings.emplace_back("the file ends in the middle of a frame, which is left out");
    if (measurement.name != "msd" || !unwinding.doubtful()) continue;
    measurement.warnings.emplace_back(
        "a disk is fast enough to move half a box between two frames: its way cannot be told from them");
  }
  return found;
}

}  // namespace carom
