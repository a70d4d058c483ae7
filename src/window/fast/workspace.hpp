// All that a window works with, and those of its steps that are not hot.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "../encounter.hpp"
#include "calendar.hpp"
#include "carom/state/state.hpp"
#include "carom/window/books.hpp"
#include "carom/window/patch.hpp"
#include "carom/window/solver.hpp"
#include "cells.hpp"
#include "huge_pages.hpp"
#include "kernel_scalar.hpp"
#include "lists.hpp"
#include "record.hpp"

namespace carom::fast {

/// Events of one time are taken in this order: grid events first, then by (smaller id, larger id, image).
struct EventKey {
  bool physical = false;
  DiskId i = 0;
  DiskId j = 0;
  Image image;

  friend constexpr auto operator<=>(const EventKey&, const EventKey&) = default;
};

/// A disk's history after one more event: whose hash is the same had, as good as certainly, the same events.
inline std::uint64_t next_history(std::uint64_t history, double time, DiskId partner, Image image,
                                  Vec2 velocity) noexcept {
  constexpr std::uint64_t kFirst = 0x9E3779B97F4A7C15;  // odd, with bits as if at random
  constexpr std::uint64_t kSecond = 0xC2B2AE3D27D4EB4F;
  const auto image_bits = static_cast<std::uint64_t>(static_cast<std::uint32_t>(image.x * 65536 + image.y)) << 32;
  history = (history ^ std::bit_cast<std::uint64_t>(time)) * kFirst;
  history = (std::rotl(history, 29) ^ std::bit_cast<std::uint64_t>(velocity.x)) * kSecond;
  history = (std::rotl(history, 31) ^ std::bit_cast<std::uint64_t>(velocity.y)) * kFirst;
  return (std::rotl(history, 27) ^ (image_bits | partner)) * kSecond;
}

/// The earliest contact that a prediction found.
struct Contact {
  double time = predict::kNever;
  Index partner = kNobody;
  EventKey key;
};

/// One window's disks, lists and calendar. Members above the line are read and written by the hot loop (Events).
class Workspace {
 public:
  Workspace(const System& of, const SolverOptions& options);

  /// Loads the window's start, unless it is the end of the window closed before.
  void open(const State& start, Books& to, std::vector<Collision>* rows);
  /// Loads the disks of a patch. Counts go to `to`, which has no arrays; sums begin with those of `from`.
  void open_patch(const State& start, const Books& from, const PatchTask& task, double until, Books& to,
                  std::vector<Collision>* rows);
  /// After all events before `time`: writes what became of the patch's disks.
  void store_patch(double time, const PatchOutput& output, PatchReport& report);
  /// The disks at `time`, from the loaded ones.
  void read(double time, Frame& frame) const;
  /// Enters in the books what the disks' own records count.
  void book();
  /// Carries all disks to the window's end, in the records and in `next`.
  void close(State& next);

  const System& system;
  double length = 0;       // of the window (time)
  bool one_kind = true;    // all disks have the same radius and mass
  bool predicted = false;  // the calendar holds the first event of every disk
  Index first_unpredicted = 0;
  Array<Record> records;
  Array<DiskId> ids;
  Array<double> virial;          // Σ ½ |J| σ of each disk, from the books on
  Array<double> wall_impulse;    // Σ |J| of each disk, from the books on; empty where there are no walls
  Array<double> last_contact;    // of each disk (time); empty in elastic systems
  std::unique_ptr<Lists> lists;  // one of the two
  std::unique_ptr<Cells> cells;
  Calendar calendar;
  double least_distance_squared = predict::kNever;  // at any contact, where there is one kind of disk
  Books* books = nullptr;
  std::vector<Collision>* log = nullptr;
  std::uint64_t collisions = 0;  // not yet in the books

  // Of a patch; empty and 0 where all disks are here.
  bool patched = false;
  Array<Role> roles;
  Array<std::uint64_t> histories;  // see NearCopy
  Array<double> last_events;       // of each disk: what would happen to it later is left out (time)
  std::uint64_t contacts = 0;      // of disks, the halo's too
  bool met_far = false;

  // ----------------------------------------------------------------------------------------------------------

  /// The earliest contact of disk k with anything in its list, of whatever kind the list is.
  [[nodiscard]] Contact earliest_contact(Index k) const;
  /// The same, noted with its image where the disk's neighbours are kept.
  Nearest settled_contact(Index k);
  /// The image of the partner in disk k's next event.
  [[nodiscard]] Image partner_image(Index k) const { return cells ? cells->partner_image(k) : lists->partner_image(k); }
  /// Of disk k's next event.
  [[nodiscard]] EventKey key_of(Index k) const;
  /// Empties the calendar and fits its buckets to the events predicted for this window or counted in the last.
  void start_calendar();
  /// Folds the position into the box; returns how many periods were taken off.
  Image fold(Index k);
  /// A new list for disk k where it is at `time`.
  void renew_list(Index k, double time);
  /// Whether lists are renewed again and again because disks fly far in one window.
  [[nodiscard]] bool lists_are_narrow() const noexcept { return renewals_now_ > renewals_allowed_; }
  /// Makes all lists anew around where the disks are at `time`, with twice the shell. All disks have to be predicted
  /// again.
  void widen_lists(double time);
  /// Generation of a contact of disks i and j at `time`, one of which had an event at that time before.
  std::uint32_t next_generation(Index i, Index j, double time);
  /// The TC rule.
  double restitution_at(double time, double last, double restitution, bool counted) noexcept;
  /// Returns how many periods were taken off the disk's position.
  Image collide_with_wall(Index k, double time);
  /// No pair may overlap at a window's end and no disk reach past a wall, wherever it is thought to be: a missed
  /// collision would show here.
  void note_overlaps_of(Index k);
  void note_overlaps_with_walls();
  void note_overlap(double overlap) noexcept { books->largest_overlap = std::max(books->largest_overlap, overlap); }
  [[nodiscard]] double mass(Index k) const noexcept { return system.mass(ids[k]); }
  /// Whether what happens to a pair with disk k's smaller id, or to disk k at a wall, is counted here: by its owner.
  [[nodiscard]] bool counts(Index k) const noexcept { return !patched || roles[k] == Role::owned; }
  /// In a patch: disk k is on its way, at a grid event. What goes far is noted.
  void note_excursion(Index k, double time);

 private:
  using Turns = std::pair<std::int64_t, std::int64_t>;

  /// All disks to `time`, folded into the box; cells and lists know of it. Not those of a patch that were left alone.
  void carry_all(double time);
  [[nodiscard]] bool is_left_alone(Index k, double time) const noexcept { return patched && last_events[k] < time; }
  void store_owned(Index k, double time, const PatchOutput& output) const;
  void begin_window(const State& start, Books& to, std::vector<Collision>* rows);
  void load_sums(const Books& from);
  void note_least_distance() noexcept;
  [[nodiscard]] Vec2 roaming() const noexcept;
  [[nodiscard]] bool continues(const State& start) const noexcept;
  void load(const State& start, std::span<const DiskId> order);
  void find_neighbours();
  void build_lists(const Extent& range);
  [[nodiscard]] double default_cell_size(const Extent& range) const noexcept;
  [[nodiscard]] bool chooses_cells(const Extent& range) const;
  [[nodiscard]] Vec2 size_of(const Extent& range) const noexcept;
  [[nodiscard]] Vec2 unfolded(Index k, Vec2 place) const;
  template <class Visit>
  void for_neighbours(Index k, Visit visit) const {
    if (cells) {
      cells->for_neighbours(k, visit);
    } else {
      lists->for_neighbours(k, visit);
    }
  }
  [[nodiscard]] bool may_meet_wall(Index k) const noexcept {
    return system.box.has_walls() &&
           (cells ? ((*cells)[k].traits & Place::kNearWall) != 0 : ((*lists)[k].traits & List::kNearWall) != 0);
  }
  [[nodiscard]] Extent extent(double time) const noexcept;
  [[nodiscard]] double rounding_slack(const Extent& extent) const noexcept;
  [[nodiscard]] double widest_shell() const noexcept;
  [[nodiscard]] double default_shell(const Extent& extent) const noexcept;
  [[nodiscard]] std::uint32_t generation_before(Index k, double time) const noexcept;

  SolverOptions options_;
  ListSteps list_steps_;
  const State* start_ = nullptr;
  bool closed_ = false;          // the records stand at the end of a window
  double rate_ = 0;              // events entered per time in the window before; 0 if unknown
  std::optional<Extent> part_;   // of the plane, in a patch
  double clear_ = 0;             // see PatchTask
  double packing_fraction_ = 0;  // of the system
  Array<Vec2> starts_;           // of the patch's disks
  std::unordered_map<Index, Rectangle> paths_;
  double slack_ = 0;                        // that lists and cells allow for the rounding of positions (length)
  std::uint64_t renewals_ = 0;              // of lists since the disks were put in order
  std::uint64_t renewals_now_ = 0;          // of lists in this window since they were last widened
  std::uint64_t renewals_allowed_ = 0;      // so many before they are widened
  std::unordered_map<Index, Turns> turns_;  // of disks that crossed a seam in this window
  Array<std::uint32_t> booked_;             // events of each disk that are in the books; empty if none are
  double tie_time_ = -1;
  std::unordered_map<Index, std::uint32_t> generations_;  // above 0, of events at tie_time_
};

}  // namespace carom::fast
