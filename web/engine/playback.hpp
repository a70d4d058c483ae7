// A few disks on their way through time, with every contact known and every earlier state at hand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "carom/state/scene.hpp"
#include "carom/state/state.hpp"
#include "carom/window/books.hpp"
#include "carom/window/collision.hpp"
#include "carom/window/solver.hpp"

namespace carom::page {

/// One contact, and the two bodies at it. Of a wall only the disk is filled in.
struct Contact {
  double time = 0;
  std::size_t window = 0;
  Collision row;
  Vec2 position_i, position_j;  ///< j: of the copy that is met (length)
  Vec2 before_i, before_j;      ///< velocities (length/time)
  Vec2 after_i, after_j;
  double restitution = 1;  ///< that was used: 1 where the TC rule made the contact elastic
};

/// Going back is exact: the starts of all windows are kept, and a window is a pure function of its start.
class Playback {
 public:
  /// Throws Error if the setup cannot be simulated.
  explicit Playback(Setup setup);

  [[nodiscard]] const System& system() const noexcept { return system_; }
  /// Contacts known so far, in the order of the log.
  [[nodiscard]] const std::vector<Contact>& contacts() const noexcept { return contacts_; }

  /// Finds all contacts up to `time`, and more. Stops at kMostContacts.
  void know_until(double time);
  /// Finds contacts until there are more than `count`, or none can come any more, or none comes before `horizon`.
  void know_more_than(std::size_t count, double horizon);

  /// All disks at `time`; contacts at exactly this time have not happened yet.
  Frame frame_at(double time);
  /// All disks just after contact k, and all others of that same moment.
  Frame frame_after(std::size_t k);

  static constexpr std::size_t kMostContacts = 200000;

 private:
  void advance_one_window();
  void take_apart(const std::vector<Collision>& log);
  Frame read(std::size_t window, double offset);
  [[nodiscard]] std::size_t window_of(double time) const noexcept;
  [[nodiscard]] double known_until() const noexcept { return starts_.back().clock.start; }
  [[nodiscard]] bool is_over() const noexcept;

  System system_;
  std::unique_ptr<Solver> solver_;
  std::vector<State> starts_;  // of all windows known, and of the one after them
  Books books_;
  std::vector<Contact> contacts_;
};

}  // namespace carom::page
