// The wave vectors that fit into a periodic box, in shells of nearly equal length.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "carom/base/vec2.hpp"
#include "carom/state/state.hpp"

namespace carom {

/// k = 2π (x/L_x, y/L_y) with whole x and y; of k and −k only one.
struct WaveVector {
  int x = 0;
  int y = 0;

  friend constexpr auto operator<=>(const WaveVector&, const WaveVector&) = default;
};

/// Those in a range of lengths: entries first … last − 1 of the list.
struct WaveShell {
  std::size_t first = 0;
  std::size_t last = 0;
  double mean_k = 0;  ///< (1/length)
  double mean_k2 = 0;
  double mean_k4 = 0;
};

class WaveVectors {
 public:
  /// Shells of equal width from 0 to `k_max`, at most `shells`, and none narrower than 2π over the shorter side. A
  /// shell that holds more than its share of `most` vectors is represented by so many, evenly over its directions.
  WaveVectors(Vec2 box, double k_max, std::size_t shells, std::size_t most);

  [[nodiscard]] const std::vector<WaveVector>& vectors() const noexcept { return vectors_; }
  [[nodiscard]] const std::vector<WaveShell>& shells() const noexcept { return shells_; }

  /// ρ_k = Σ exp(i k·r) over all disks, for every vector; in the order of ids. Takes some N × vectors operations.
  [[nodiscard]] std::vector<std::complex<double>> density_waves(const Frame& frame) const;

 private:
  [[nodiscard]] Vec2 wave(WaveVector v) const noexcept { return {v.x * unit_.x, v.y * unit_.y}; }
  [[nodiscard]] std::vector<WaveVector> all_between(double low, double high) const;
  [[nodiscard]] std::vector<WaveVector> some_between(double low, double high, std::size_t count) const;
  void add_shell(const std::vector<WaveVector>& vectors);

  Vec2 unit_;  // 2π/L
  std::vector<WaveVector> vectors_;
  std::vector<WaveShell> shells_;
  int largest_x_ = 0;  // of |x| and y in the list
  int largest_y_ = 0;
};

}  // namespace carom
