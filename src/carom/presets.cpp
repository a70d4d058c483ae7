#include "carom/carom/presets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "carom/base/error.hpp"

namespace carom {
namespace {

void require_positive(std::string_view name, double value) {
  if (!(value > 0) || std::isinf(value)) throw Error(fmt::format("{} is {}: it must be a number above 0", name, value));
}

void check(const GasPreset& preset) {
  if (preset.disks == 0) throw Error("disks is 0: a gas needs at least 1 disk");
  require_positive("packing", preset.packing);
  require_positive("radius ratio", preset.radius_ratio);
  require_positive("mass ratio", preset.mass_ratio);
  require_positive("aspect", preset.aspect);
  if (!(preset.temperature >= 0) || std::isinf(preset.temperature)) {
    throw Error(fmt::format("temperature is {}: it must be a number, 0 or more", preset.temperature));
  }
  if (preset.fraction && !(*preset.fraction >= 0 && *preset.fraction <= 1)) {
    throw Error(fmt::format("fraction is {}: it must lie in [0, 1]", *preset.fraction));
  }
}

std::uint64_t count_of_second_kind(const GasPreset& preset) {
  const bool one_kind = preset.radius_ratio == 1 && preset.mass_ratio == 1;
  const double fraction = preset.fraction.value_or(one_kind ? 0 : 0.5);
  return one_kind ? 0 : static_cast<std::uint64_t>(std::rint(fraction * static_cast<double>(preset.disks)));
}

}  // namespace

SceneFile make_gas(const GasPreset& preset) {
  check(preset);
  const std::uint64_t second = count_of_second_kind(preset);
  const std::uint64_t first = preset.disks - second;

  SceneFile file;
  file.scene.title = fmt::format("Gas of {} disks at packing fraction {}", preset.disks, preset.packing);
  file.scene.boundary = {preset.boundary, preset.boundary};
  if (preset.aspect != 1) file.scene.aspect = preset.aspect;
  const auto add_kind = [&](std::uint64_t count, double radius, double mass) {
    if (count == 0) return;
    GasSpec gas;
    gas.count = count;
    gas.radius = radius;
    gas.mass = mass;
    gas.temperature = preset.temperature;
    gas.seed = preset.seed;
    gas.start = preset.start;
    file.scene.gas.push_back(gas);
  };
  add_kind(first, 0.5, 1);
  add_kind(second, 0.5 * preset.radius_ratio, preset.mass_ratio);

  // Each kind's share of the packing fraction is its share of the area.
  double area = 0;
  for (const GasSpec& gas : file.scene.gas) area += static_cast<double>(*gas.count) * gas.radius * gas.radius;
  for (GasSpec& gas : file.scene.gas) {
    const double share = static_cast<double>(*gas.count) * gas.radius * gas.radius / area;
    gas.packing_fraction = share == 1 ? preset.packing : preset.packing * share;
  }
  file.run.collisions = 20 * preset.disks / 2;
  return file;
}

SceneFile make_two_disks() {
  SceneFile file;
  file.scene.title = "Two equal disks, one at rest, meeting at an angle";
  file.scene.boundary = {Boundary::open, Boundary::open};
  DiskSpec moving;
  moving.position = {-3, 0};
  moving.velocity = {1, 0};
  DiskSpec resting;
  resting.position = {0.6, 0.8};
  file.scene.disks = {moving, resting};
  file.run.until = 6;
  return file;
}

SceneFile make_cradle(std::uint64_t disks) {
  if (disks < 2) throw Error(fmt::format("a cradle of {} disks does not swing: give at least 2", disks));
  if (static_cast<double>(disks) > most_disks())
    throw Error(fmt::format("a cradle of {} disks is more than this machine's memory holds", disks));
  const double row = static_cast<double>(disks - 1);
  SceneFile file;
  file.scene.title = fmt::format("Newton's cradle of {} disks between two walls", disks);
  file.scene.size = Vec2{row + 10, 2};
  file.scene.boundary = {Boundary::reflecting, Boundary::open};
  DiskSpec incoming;
  incoming.position = {2, 1};
  incoming.velocity = {1, 0};
  file.scene.disks.push_back(incoming);
  for (std::uint64_t k = 0; k + 1 < disks; ++k) {
    DiskSpec resting;
    resting.position = {5.5 + static_cast<double>(k), 1};
    file.scene.disks.push_back(resting);
  }
  file.run.until = 40;
  return file;
}

SceneFile make_break() {
  constexpr double kRadius = 0.028575;  // 2¼ inches across
  constexpr double kMass = 0.17;
  constexpr double kGap = 5e-5;  // racked balls never quite touch, and three touching disks have no unique outcome
  constexpr Vec2 kTable{2.54, 1.27};
  SceneFile file;
  file.scene.title = "The break on a 9-foot pool table, without friction";
  file.scene.size = kTable;
  file.scene.boundary = {Boundary::reflecting, Boundary::reflecting};

  DiskSpec ball;
  ball.radius = kRadius;
  ball.mass = kMass;
  ball.position = {0.25 * kTable.x, 0.5 * kTable.y + 0.001};  // a little off the axis, so that the rack breaks unevenly
  ball.velocity = {8, 0};
  file.scene.disks.push_back(ball);

  const double step = 2 * kRadius + kGap;
  ball.velocity = {};
  for (int row = 0; row < 5; ++row) {
    for (int k = 0; k <= row; ++k) {
      ball.position = {0.75 * kTable.x + row * step * std::sqrt(3.0) / 2, 0.5 * kTable.y + (k - 0.5 * row) * step};
      file.scene.disks.push_back(ball);
    }
  }
  file.run.until = 5;
  return file;
}

SceneFile make_galperin(int digits) {
  if (digits < 1 || digits > 7) throw Error(fmt::format("digits is {}: it must be from 1 to 7", digits));
  double mass_ratio = 1;
  for (int k = 1; k < digits; ++k) mass_ratio *= 100;

  SceneFile file;
  file.scene.title = fmt::format("Galperin's billiard: {} digit{} of pi", digits, digits == 1 ? "" : "s");
  file.scene.size = Vec2{20, 2};
  file.scene.boundary = {Boundary::reflecting, Boundary::open};
  DiskSpec light;
  light.position = {1.5, 1};
  DiskSpec heavy;
  heavy.position = {3.5, 1};
  heavy.velocity = {-1, 0};
  heavy.mass = mass_ratio;
  file.scene.disks = {light, heavy};
  // After the last contact (time 8.6 at the latest, for 3 digits) and before the heavy disk reaches the right wall.
  file.run.until = 16;
  return file;
}

SceneFile make_brownian(std::uint64_t seed) {
  SceneFile file;
  file.scene.title = "A heavy disk in a gas of light ones: Brownian motion";
  file.scene.size = Vec2{60, 60};
  DiskSpec heavy;
  heavy.position = {30, 30};
  heavy.radius = 4;
  heavy.mass = 50;
  file.scene.disks.push_back(heavy);
  GasSpec gas;
  gas.count = 1000;
  gas.seed = seed;
  file.scene.gas.push_back(gas);
  file.run.until = 20;
  return file;
}

}  // namespace carom
