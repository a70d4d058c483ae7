// The pressure on each wall by itself.
//
// βP = Σ |J| over the wall's contacts / (its length × t × kT), kT from all degrees of freedom. Each window is a sample.
#include <array>
#include <string>

#include "carom/base/error.hpp"
#include "carom/observe/blocking.hpp"
#include "estimates.hpp"
#include "kinds.hpp"

namespace carom {
namespace {

constexpr std::array kWalls{Wall::left, Wall::right, Wall::bottom, Wall::top};

class WallPressure final : public Observable {
 public:
  explicit WallPressure(const System& system) {
    for (const Wall wall : kWalls) {
      if (!system.box.reflecting(axis_of(wall))) continue;
      sides_.push_back({wall, axis_of(wall) == 0 ? system.box.size.y : system.box.size.x});
    }
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "wall_pressure"; }
  [[nodiscard]] bool wants_collisions() const noexcept override { return true; }

  void on_window(const WindowRecord& window) override {
    const double kT =
        0.5 * (temperature(window.system, window.before.disks) + temperature(window.system, window.after.disks));
    if (!(kT > 0)) return;
    std::array<double, kWalls.size()> impulse{};
    for (const Collision& collision : window.collisions) {
      if (is_wall(collision.j)) impulse[static_cast<std::size_t>(wall_of(collision.j))] += collision.impulse;
    }
    const double duration = window.before.clock.length;
    time_ += duration;
    for (Side& side : sides_) {
      const double sum = impulse[static_cast<std::size_t>(side.wall)] / (side.length * kT);
      side.sum += sum;
      side.samples.add(sum / duration);
    }
  }

  [[nodiscard]] Measurement result() const override {
    Measurement measurement;
    measurement.name = name();
    for (const Side& side : sides_) {
      const double spacing = time_ / static_cast<double>(side.samples.result().samples);
      add_estimate(measurement, "pressure_" + std::string(name_of(side.wall)), "1/length²", side.samples, spacing,
                   side.sum / time_);
    }
    return measurement;
  }

  void exchange(SumsExchange sums) override {
    sums.number("time", time_);
    for (Side& side : sides_) {
      SumsExchange own = sums.below(name_of(side.wall));
      own.number("sum", side.sum);
      side.samples.exchange(own);
    }
  }

 private:
  struct Side {
    Wall wall;
    double length = 0;
    double sum = 0;  // ∫ βP dt
    Blocking samples = {};
  };
  std::vector<Side> sides_;
  double time_ = 0;
};

}  // namespace

ObservableKind wall_pressure_kind() {
  return {.name = "wall_pressure",
          .summary = "pressure on each wall by itself",
          .from_frames = false,
          .options = {},
          .make = [](const Subject& subject, const ObservableOptions&) -> std::unique_ptr<Observable> {
            const Box& box = subject.system.box;
            if (!box.has_walls()) throw Error("wall_pressure: the box has no walls");
            if (box.boundary[0] == Boundary::open || box.boundary[1] == Boundary::open) {
              throw Error("wall_pressure: the walls have no end where the plane is open");
            }
            return std::make_unique<WallPressure>(subject.system);
          }};
}

}  // namespace carom
