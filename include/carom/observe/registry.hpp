// Which observables there are, what they can be told, and how they are made.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "carom/observe/observable.hpp"
#include "carom/run/settings.hpp"

namespace carom {

/// What an observable is made for.
struct Subject {
  const System& system;
  const Frame& start;                  ///< the first frame: defaults such as the interval depend on it
  std::optional<double> spacing = {};  ///< time between the frames of a saved trajectory; absent in a run
};

/// A number that an observable can be told: [[observe]]'s keys beside `name`.
struct OptionKind {
  std::string_view name;
  std::string_view meaning;
  std::string_view standard;  ///< what it is if absent, for people: "64", "a mean free time"
  bool whole = false;
  double least = 0;
  double most = std::numeric_limits<double>::max();
};

/// The options of one ObserveSpec, checked against the kind's list.
class ObservableOptions {
 public:
  explicit ObservableOptions(const ObserveSpec& spec) : spec_(&spec) {}

  [[nodiscard]] std::optional<double> find(std::string_view option) const;
  [[nodiscard]] double number(std::string_view option, double standard) const;
  [[nodiscard]] std::size_t count(std::string_view option, std::size_t standard) const;

 private:
  const ObserveSpec* spec_;
};

/// An entry of the registry.
struct ObservableKind {
  std::string_view name;
  std::string_view summary;  ///< one line
  bool from_frames;          ///< whether a saved trajectory is enough; else it needs the windows of a run
  std::vector<OptionKind> options;
  /// Throws Error, without a place, if this system has no such thing ("the plane is open: it has no pressure").
  std::unique_ptr<Observable> (*make)(const Subject&, const ObservableOptions&);
};

/// All that can be observed, in alphabetic order.
const std::vector<ObservableKind>& observable_kinds();

/// The observable of a specification. Throws Error with the specification's places for an unknown name or option
/// (with the nearest known one), for a value out of range, and for what this system does not have.
std::unique_ptr<Observable> make_observable(const ObserveSpec& spec, const Subject& subject);

/// What is wrong with names and options, as far as that can be told without a system: an unknown name, a name given
/// twice, an unknown option, a value out of range. Empty if all is well.
std::vector<Problem> problems_of(const std::vector<ObserveSpec>& specs);

/// The option `interval` of observables that want frames, with the text of its default.
OptionKind interval_option(std::string_view standard);

/// Time between frames: the option `interval` if given; a saved trajectory's spacing; else the power of two next below
/// so many mean free times of a gas of this density (1 where nothing moves). Throws Error if `interval` is given for a
/// saved trajectory, whose frames are where they are.
double frame_interval(const ObservableOptions& options, const Subject& subject, double mean_free_times);

}  // namespace carom
