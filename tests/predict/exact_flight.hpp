// Two flights in 100 digits: the oracle for times of contact.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "carom/predict/contact.hpp"

namespace carom::predict {

using Exact = boost::multiprecision::cpp_bin_float_100;

/// What contact_of_disks() is given.
struct Pair {
  Flight i, j;
  Vec2 image;
  double sigma = 1;
};

/// The same motion without rounding.
class ExactPair {
 public:
  explicit ExactPair(const Pair& pair)
      : pair_(pair), start_(std::max(pair.i.time, pair.j.time)), rx_(0), ry_(0), vx_(0), vy_(0) {
    vx_ = Exact(pair.j.velocity.x) - pair.i.velocity.x;
    vy_ = Exact(pair.j.velocity.y) - pair.i.velocity.y;
    const Exact since_i = start_ - pair.i.time;
    const Exact since_j = start_ - pair.j.time;
    rx_ = pair.j.position.x + pair.j.velocity.x * since_j + pair.image.x - pair.i.position.x -
          pair.i.velocity.x * since_i;
    ry_ = pair.j.position.y + pair.j.velocity.y * since_j + pair.image.y - pair.i.position.y -
          pair.i.velocity.y * since_i;
  }

  /// Distance of the rims at a time; negative where the disks overlap.
  [[nodiscard]] Exact gap(double time) const {
    const Exact x = rx_ + vx_ * (time - start_), y = ry_ + vy_ * (time - start_);
    return sqrt(x * x + y * y) - pair_.sigma;
  }

  /// r·v / |v| at a time: how far the pair still has to fly to its closest approach, negative before it.
  [[nodiscard]] Exact past_closest_approach(double time) const {
    const Exact t = time - start_;
    return ((rx_ + vx_ * t) * vx_ + (ry_ + vy_ * t) * vy_) / sqrt(vx_ * vx_ + vy_ * vy_);
  }

  /// How much deeper than at the start, or than touching, the disks would be if they flew through each other.
  [[nodiscard]] Exact penetration() const {
    const Exact distance = sqrt(rx_ * rx_ + ry_ * ry_);
    const bool approaching = rx_ * vx_ + ry_ * vy_ < 0;
    const Exact closest = approaching ? Exact(abs(rx_ * vy_ - ry_ * vx_) / sqrt(vx_ * vx_ + vy_ * vy_)) : distance;
    return std::min(distance, Exact(pair_.sigma)) - closest;
  }

 private:
  Pair pair_;
  Exact start_;
  Exact rx_, ry_, vx_, vy_;
};

}  // namespace carom::predict
