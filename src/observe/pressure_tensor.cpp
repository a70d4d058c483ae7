// The pressure tensor of a periodic box.
//
// βP_ab = [Σ m v_a v_b × N/(degrees of freedom along the axes) + (1/t) Σ |J| σ n_a n_b] / (A kT): the momentum that
// disks carry, and what collisions hand over their distance σ along the line of centres n. The kinetic part is scaled
// such that its trace is 2 N kT, as in the scalar pressure. Each window is a sample, the kinetic part the mean of its
// two ends.
#include <array>
#include <cmath>
#include <string>

#include "carom/base/error.hpp"
#include "carom/observe/blocking.hpp"
#include "carom/observe/theory.hpp"
#include "estimates.hpp"
#include "kinds.hpp"
#include "motion.hpp"

namespace carom {
namespace {

/// Components xx, xy, yy.
using Tensor = std::array<double, 3>;

void add_product(Tensor& tensor, double factor, Vec2 a) {
  tensor[0] += factor * a.x * a.x;
  tensor[1] += factor * a.x * a.y;
  tensor[2] += factor * a.y * a.y;
}

class PressureTensor final : public Observable {
 public:
  explicit PressureTensor(const System& system)
      : disks_(static_cast<double>(system.size())),
        density_(disks_ / (system.box.size.x * system.box.size.y)),
        fluid_(fluid_of_equal_disks(system)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "pressure_tensor"; }
  [[nodiscard]] bool wants_collisions() const noexcept override { return true; }

  void on_window(const WindowRecord& window) override {
    const System& system = window.system;
    const double duration = window.before.clock.length;
    Tensor carried{};
    add_kinetic(system, window.before.disks, carried);
    add_kinetic(system, window.after.disks, carried);
    Tensor handed{};
    for (const Collision& collision : window.collisions) {
      const double sigma = system.radius(collision.i) + system.radius(collision.j);
      add_product(handed, collision.impulse * sigma, collision.normal);
    }
    const double kT = 0.5 * (temperature(system, window.before.disks) + temperature(system, window.after.disks));
    if (!(kT > 0)) return;
    for (std::size_t c = 0; c < 3; ++c) {
      const double z = (0.5 * carried[c] + handed[c] / duration) / (disks_ * kT);
      sums_[c] += z * duration;
      samples_[c].add(z);
    }
    time_ += duration;
  }

  [[nodiscard]] Measurement result() const override {
    constexpr std::array kNames{"xx", "xy", "yy"};
    Measurement all;
    const double spacing = time_ / static_cast<double>(samples_[0].result().samples);
    for (std::size_t c = 0; c < 3; ++c) {
      Estimate& z = add_estimate(all, kNames[c], "", samples_[c], spacing, sums_[c] / time_);
      if (fluid_) {
        z.theory = c == 1 ? 0 : finite_compressibility(*fluid_);
        z.theory_source = c == 1 ? "isotropy" : source_of_compressibility(*fluid_);
      }
    }
    Measurement measurement{.name = std::string(name())};
    for (const Estimate& z : all.estimates) {
      measurement.estimates.push_back(scaled(z, "pressure_" + z.name, "1/length²", density_));
    }
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    sums.number("time", time_);
    for (std::size_t c = 0; c < 3; ++c) {
      SumsExchange own = sums.below(std::to_string(c));
      own.number("sum", sums_[c]);
      samples_[c].exchange(own);
    }
  }

 private:
  /// Momentum is conserved along both axes: N disks have N − 1 degrees of freedom along each.
  void add_kinetic(const System& system, const Frame& frame, Tensor& tensor) const {
    const Vec2 drift = drift_velocity(system, frame);
    const double scale = disks_ / (disks_ - 1);
    for (std::size_t k = 0; k < frame.size(); ++k) {
      add_product(tensor, scale * system.mass(k), frame.velocity(k) - drift);
    }
  }

  const double disks_;
  const double density_;
  const std::optional<EqualDisks> fluid_;

  Tensor sums_{};  // ∫ βP A/N dt
  double time_ = 0;
  std::array<Blocking, 3> samples_;
};

}  // namespace

ObservableKind pressure_tensor_kind() {
  return {.name = "pressure_tensor",
          .summary = "the components of the pressure, from every collision",
          .from_frames = false,
          .options = {},
          .make = [](const Subject& subject, const ObservableOptions&) -> std::unique_ptr<Observable> {
            const Box& box = subject.system.box;
            if (!box.periodic(0) || !box.periodic(1)) {
              throw Error("pressure_tensor: the box must be periodic along both axes; wall_pressure is for walls");
            }
            if (subject.system.size() < 2) throw Error("pressure_tensor: there must be two disks or more");
            return std::make_unique<PressureTensor>(subject.system);
          }};
}

}  // namespace carom
