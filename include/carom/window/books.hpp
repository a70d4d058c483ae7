// What is counted and summed while windows go by. Sums are kept per disk, in the order of that disk's own events,
// so that they have the same bits for any decomposition of the work.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom {

struct Books {
  std::uint64_t collisions = 0;       ///< of two disks
  std::uint64_t wall_collisions = 0;  ///< of a disk and a wall
  std::uint64_t ties = 0;             ///< events of a generation above 0: a disk's second, third … at one time
  std::uint64_t collapses = 0;        ///< contacts that the TC rule made elastic
  double largest_overlap =
      0;  ///< at any contact or window's end, in contact distances of the pair; of disk and wall in diameters

  // Arrays of N.
  std::vector<std::uint64_t> events_of;  ///< contacts of each disk, with disks and walls
  std::vector<double> virial_of;         ///< Σ ½ |J| σ over each disk's contacts with disks (energy)
  std::vector<double> wall_impulse_of;   ///< Σ |J| over each disk's contacts with walls; empty where there are none

  explicit Books(std::size_t disks, bool walls = true)
      : events_of(disks), virial_of(disks), wall_impulse_of(walls ? disks : 0) {}

  [[nodiscard]] std::uint64_t events() const noexcept { return collisions + wall_collisions; }

  /// The same without arrays.
  [[nodiscard]] Books counts() const {
    Books counts(0);
    counts.set_counts(*this);
    return counts;
  }
  /// Takes over all but the arrays.
  void set_counts(const Books& other) noexcept {
    collisions = other.collisions;
    wall_collisions = other.wall_collisions;
    ties = other.ties;
    collapses = other.collapses;
    largest_overlap = other.largest_overlap;
  }
};

}  // namespace carom
