#include "wave_vectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "carom/state/system.hpp"

namespace carom {
namespace {

// Disks whose waves are multiplied at a time, so that compilers make vector code of it.
constexpr std::size_t kLanes = 8;
using Lanes = std::array<double, kLanes>;

/// exp(i n φ) for n = 0, 1, … and a few disks.
class Harmonics {
 public:
  explicit Harmonics(int largest) : real_(static_cast<std::size_t>(largest) + 1), imaginary_(real_.size()) {}

  /// Lanes from `count` on are given amplitude 0.
  void set(const double* coordinates, std::size_t count, double unit) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const bool used = lane < count;
      const double phase = used ? unit * coordinates[lane] : 0;
      real_[0][lane] = used ? 1 : 0;
      imaginary_[0][lane] = 0;
      step_real_[lane] = std::cos(phase);
      step_imaginary_[lane] = std::sin(phase);
    }
    for (std::size_t n = 1; n < real_.size(); ++n) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const double re = real_[n - 1][lane];
        const double im = imaginary_[n - 1][lane];
        real_[n][lane] = re * step_real_[lane] - im * step_imaginary_[lane];
        imaginary_[n][lane] = re * step_imaginary_[lane] + im * step_real_[lane];
      }
    }
  }

  [[nodiscard]] const Lanes& real(int n) const noexcept { return real_[static_cast<std::size_t>(n)]; }
  [[nodiscard]] const Lanes& imaginary(int n) const noexcept { return imaginary_[static_cast<std::size_t>(n)]; }

 private:
  std::vector<Lanes> real_, imaginary_;
  Lanes step_real_{}, step_imaginary_{};
};

/// Σ over lanes of exp(i k·r).
std::complex<double> sum_of_waves(const Harmonics& along_x, const Harmonics& along_y, WaveVector v) noexcept {
  const Lanes& x_real = along_x.real(std::abs(v.x));
  const Lanes& x_imaginary = along_x.imaginary(std::abs(v.x));
  const Lanes& y_real = along_y.real(v.y);
  const Lanes& y_imaginary = along_y.imaginary(v.y);
  const double sign = v.x < 0 ? -1 : 1;
  Lanes real;
  Lanes imaginary;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    real[lane] = x_real[lane] * y_real[lane] - sign * (x_imaginary[lane] * y_imaginary[lane]);
    imaginary[lane] = x_real[lane] * y_imaginary[lane] + sign * (x_imaginary[lane] * y_real[lane]);
  }
  const auto sum = [](const Lanes& l) { return ((l[0] + l[1]) + (l[2] + l[3])) + ((l[4] + l[5]) + (l[6] + l[7])); };
  return {sum(real), sum(imaginary)};
}

/// The one of k and −k that is listed.
WaveVector upper_half(WaveVector v) noexcept { return v.y > 0 || (v.y == 0 && v.x > 0) ? v : WaveVector{-v.x, -v.y}; }

}  // namespace

WaveVectors::WaveVectors(Vec2 box, double k_max, std::size_t shells, std::size_t most)
    : unit_{2 * kPi / box.x, 2 * kPi / box.y} {
  const double fitting = std::floor(k_max / std::max(unit_.x, unit_.y));
  const double count = std::clamp(fitting, 1.0, static_cast<double>(shells));
  const auto share = static_cast<std::size_t>(std::max(1.0, static_cast<double>(most) / count));
  for (double shell = 0; shell < count; ++shell) {
    const double low = k_max * shell / count;
    const double high = k_max * (shell + 1) / count;
    const double expected = kPi * (high * high - low * low) / (2 * unit_.x * unit_.y);
    // Shells that look small enough are listed in full, and counted to be sure.
    const bool small = expected <= 2 * static_cast<double>(share) + 100;
    std::vector<WaveVector> vectors = small ? all_between(low, high) : std::vector<WaveVector>{};
    if (!small || vectors.size() > share) vectors = some_between(low, high, share);
    if (!vectors.empty()) add_shell(vectors);
  }
}

std::vector<WaveVector> WaveVectors::all_between(double low, double high) const {
  std::vector<WaveVector> found;
  const auto half_chord = [this](double k, double along_y) {
    return static_cast<int>(std::sqrt(std::max(0.0, k * k - along_y * along_y)) / unit_.x);
  };
  const int largest_y = static_cast<int>(high / unit_.y);
  for (int y = 0; y <= largest_y; ++y) {
    const int outer = half_chord(high, y * unit_.y) + 1;
    const int inner = half_chord(low, y * unit_.y) - 1;
    for (int x = -outer; x <= outer; ++x) {
      if (x > -inner && x < inner) x = inner;
      const double k = length(wave({x, y}));
      if (k > low && k <= high && upper_half({x, y}) == WaveVector{x, y}) found.push_back({x, y});
    }
  }
  return found;
}

/// The vectors next to points spread over the half ring: even in direction, by the golden ratio in length.
std::vector<WaveVector> WaveVectors::some_between(double low, double high, std::size_t count) const {
  constexpr double kGolden = 0.6180339887498949;
  std::vector<WaveVector> found;
  for (std::size_t n = 0; n < count; ++n) {
    const double part = static_cast<double>(n) * kGolden;
    const double k = low + (high - low) * (part - std::floor(part));
    const double angle = kPi * (static_cast<double>(n) + 0.5) / static_cast<double>(count);
    const WaveVector near{static_cast<int>(std::rint(k * std::cos(angle) / unit_.x)),
                          static_cast<int>(std::rint(k * std::sin(angle) / unit_.y))};
    const double exact = length(wave(near));
    if (exact > low && exact <= high) found.push_back(upper_half(near));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void WaveVectors::add_shell(const std::vector<WaveVector>& vectors) {
  WaveShell shell{vectors_.size(), vectors_.size() + vectors.size()};
  const auto count = static_cast<double>(vectors.size());
  for (const WaveVector v : vectors) {
    const double k2 = dot(wave(v), wave(v));
    shell.mean_k += std::sqrt(k2) / count;
    shell.mean_k2 += k2 / count;
    shell.mean_k4 += k2 * k2 / count;
    largest_x_ = std::max(largest_x_, std::abs(v.x));
    largest_y_ = std::max(largest_y_, v.y);
  }
  vectors_.insert(vectors_.end(), vectors.begin(), vectors.end());
  shells_.push_back(shell);
}

std::vector<std::complex<double>> WaveVectors::density_waves(const Frame& frame) const {
  std::vector<std::complex<double>> waves(vectors_.size());
  Harmonics along_x(largest_x_);
  Harmonics along_y(largest_y_);
  for (std::size_t first = 0; first < frame.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, frame.size() - first);
    along_x.set(frame.x.data() + first, count, unit_.x);
    along_y.set(frame.y.data() + first, count, unit_.y);
    for (std::size_t k = 0; k < vectors_.size(); ++k) waves[k] += sum_of_waves(along_x, along_y, vectors_[k]);
  }
  return waves;
}

}  // namespace carom
