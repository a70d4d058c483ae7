// How many pairs of disks an ideal gas has at each distance, in a box with or without walls: what g(r) is measured by.
#pragma once

#include "carom/state/system.hpp"

namespace carom {

/// Two disks placed independently, each uniformly where its centre can be: in the whole of a periodic axis, between the
/// walls less its radius along a reflecting one.
class IdealPairs {
 public:
  /// Throws Error if an axis is open: nothing is uniform there.
  IdealPairs(const Box& box, double radius_a, double radius_b);

  /// Expected number of images of the second disk per distance (1/length) at distance r from the first; 2πr/A in a
  /// periodic box. Between walls it is less, as circles reach beyond them:
  /// p(r) = 4r ∫ c_x(r cos θ) c_y(r sin θ) dθ / (A_a A_b) over 0 … π/2, where c(u) is the length in which the first
  /// disk's coordinate can lie so that the second's, u away, is in its own range.
  [[nodiscard]] double density(double r) const;

  /// Expected number of images at distances from `low` to `high`.
  [[nodiscard]] double between(double low, double high) const;

 private:
  struct Axis {
    bool periodic = true;
    double room_a = 0;  // length in which the centre can be
    double room_b = 0;

    [[nodiscard]] double common(double u) const noexcept;
    /// Where c(u) has a kink.
    [[nodiscard]] double first_kink() const noexcept;
    [[nodiscard]] double last_kink() const noexcept { return (room_a + room_b) / 2; }
  };

  static Axis make_axis(const Box& box, int axis, double size, double radius_a, double radius_b);

  Axis x_, y_;
};

}  // namespace carom
