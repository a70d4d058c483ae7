// How the plane is divided into patches, and which disks each of them is given.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "carom/state/state.hpp"
#include "carom/state/system.hpp"
#include "carom/window/patch.hpp"

namespace carom {

/// A periodic axis of which more than this has to be loaded is loaded whole.
inline constexpr double kLargestPart = 0.7;
inline constexpr double kDisksPerBin = 6;

/// A patch's disks, and what each is to it.
struct Loading {
  Rectangle loaded;
  std::array<bool, 2> cut{false, false};
  bool whole = false;  ///< all disks of the system, as the true plane: nothing about it need be checked
  std::vector<DiskId> disks;
  std::vector<Role> roles;
  std::vector<float> shares;  ///< of the window's time: see PatchTask
};

/// The plane at a window's start, cut into columns × rows of equal rectangles; disks stand in bins, so that those of a
/// region are found quickly.
class Layout {
 public:
  /// `columns` and `rows` of at least 1.
  Layout(const System& system, std::uint32_t columns, std::uint32_t rows) noexcept;

  /// Sorts the disks into bins.
  void sort(const Frame& disks);

  [[nodiscard]] std::size_t patches() const noexcept { return std::size_t{count_[0]} * count_[1]; }
  [[nodiscard]] Rectangle owned(std::size_t patch) const noexcept;
  /// The same, but outermost sides along axes that are not periodic lie at infinity: nobody else owns what is there.
  [[nodiscard]] Rectangle territory(std::size_t patch) const noexcept;
  /// The disks within `halo` of a patch's rectangle; those within `near` of it are near. What happens beyond the halo
  /// works its way in as the window goes by, and copies that it reaches need not be advanced any more.
  void load(std::size_t patch, double near, double halo, Loading& loading) const;
  /// All disks, all owned.
  void load_all(Loading& loading) const;
  /// How far a disk's start lies from a patch's rectangle along the axis where it lies farther; 0 inside (length).
  [[nodiscard]] double distance(std::size_t patch, Vec2 position) const noexcept;
  /// Whether a path, not folded into the box, touches a patch's territory widened by `margin`.
  [[nodiscard]] bool touches(std::size_t patch, const Rectangle& path, double margin) const noexcept;
  /// Whether a path is so wide along a periodic axis that a disk near a patch on one side can have come to the other:
  /// wider than what is not loaded, if not all is.
  [[nodiscard]] bool may_come_round(const Rectangle& path) const noexcept;
  /// Of what the bins cover (length).
  [[nodiscard]] double longer_side() const noexcept { return std::max(axis_[0].size, axis_[1].size); }

 private:
  struct Axis {
    double low = 0;
    double size = 1;
    bool periodic = false;
    std::int64_t bins = 1;
    double bin = 1;  // width
  };
  struct Bins {
    std::int64_t first = 0;
    std::int64_t count = 1;
    bool cut = false;
  };
  [[nodiscard]] std::uint32_t owner_along(int axis, double x) const noexcept;
  [[nodiscard]] static std::int64_t bin_along(const Axis& axis, double x) noexcept;
  [[nodiscard]] static Bins bins_within(const Axis& axis, double low, double high) noexcept;
  void add(std::size_t patch, DiskId id, double near, double halo, Loading& loading) const;

  const System& system_;
  std::array<std::uint32_t, 2> count_;
  std::array<Axis, 2> axis_;
  const Frame* disks_ = nullptr;
  std::vector<std::uint32_t> start_;  // of each bin in order_, and the end
  std::vector<DiskId> order_;
};

}  // namespace carom
