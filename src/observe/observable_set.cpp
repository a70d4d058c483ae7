#include "carom/observe/observable_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "carom/base/error.hpp"
#include "carom/observe/replay.hpp"

namespace carom {
namespace {

/// Where nothing happens any more, windows grow without end; intervals do not.
constexpr double kMostFramesPerWindow = 1e5;

std::vector<Problem> with_place(const std::vector<Problem>& problems, const Place& place) {
  std::vector<Problem> placed = problems;
  for (Problem& problem : placed) {
    if (to_string(problem.place).empty()) problem.place = place;
  }
  return placed;
}

}  // namespace

ObservableSet::ObservableSet(const std::vector<ObserveSpec>& specs, const Subject& subject) {
  std::vector<Problem> problems = problems_of(specs);
  if (!problems.empty()) throw Error(problems);
  for (const ObserveSpec& spec : specs) {
    try {
      members_.push_back({spec, make_observable(spec, subject)});
      const Observable& made = *members_.back().observable;
      wants_collisions_ = wants_collisions_ || made.wants_collisions() || made.interval() > 0;
    } catch (const Error& error) {
      const std::vector<Problem> more = with_place(error.problems(), spec.place);
      problems.insert(problems.end(), more.begin(), more.end());
    }
  }
  if (!problems.empty()) throw Error(problems);
}

/// Infinity if it gets none.
double ObservableSet::next_frame(const Member& member) const noexcept {
  const double interval = member.observable->interval();
  if (!(interval > 0) || member.stopped) return std::numeric_limits<double>::infinity();
  return start_ + static_cast<double>(member.frames) * interval;
}

void ObservableSet::on_window(const WindowRecord& window) {
  if (!window.measured) return;
  if (!started_) start_ = window.before.clock.start;
  started_ = true;
  for (const Member& member : members_) member.observable->on_window(window);
  hand_out_frames(window);
}

void ObservableSet::stop_the_hurried(const WindowRecord& window) {
  for (Member& member : members_) {
    const double interval = member.observable->interval();
    const bool hurried = interval > 0 && window.before.clock.length > kMostFramesPerWindow * interval;
    if (hurried && !member.stopped) {
      member.stopped = true;
      member.stopped_at = window.before.clock.start;
    }
  }
}

void ObservableSet::hand_out_frames(const WindowRecord& window) {
  stop_the_hurried(window);
  const double end = window.before.clock.start + window.before.clock.length;
  std::optional<WindowReplay> replay;
  for (;;) {
    double next = end;
    for (const Member& member : members_) next = std::min(next, next_frame(member));
    if (!(next < end)) return;
    if (!replay) replay.emplace(window);
    const Frame& frame = replay->at(next);
    for (Member& member : members_) {
      if (next_frame(member) != next) continue;
      member.observable->on_frame(window.system, frame);
      ++member.frames;
    }
  }
}

void ObservableSet::on_frame(const System& system, const Frame& frame) {
  for (Member& member : members_) {
    member.observable->on_frame(system, frame);
    ++member.frames;
  }
}

std::vector<Measurement> ObservableSet::results() const {
  std::vector<Measurement> results;
  for (const Member& member : members_) {
    results.push_back(member.observable->result());
    if (!member.stopped) continue;
    results.back().warnings.push_back(
        fmt::format("no more frames from time {} on: windows there are more than {} times as long as the interval, {}",
                    member.stopped_at, kMostFramesPerWindow, member.observable->interval()));
  }
  return results;
}

void ObservableSet::exchange(SumsExchange sums) {
  sums.number("started", started_);
  sums.number("start", start_);
  for (Member& member : members_) {
    SumsExchange own = sums.below(member.observable->name());
    own.number("frames", member.frames);
    own.number("stopped", member.stopped);
    own.number("stopped_at", member.stopped_at);
    for (const auto& [option, value] : member.spec.options) {
      double kept = value;
      own.number("option/" + option, kept);
      if (kept != value) {
        throw Error(
            fmt::format("{}: the sums were made with {} = {}, not {}", member.observable->name(), option, kept, value),
            member.spec.place);
      }
    }
    member.observable->exchange(own);
  }
}

}  // namespace carom
