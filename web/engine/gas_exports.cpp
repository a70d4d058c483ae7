// What the page's gas calls.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "carom/state/state.hpp"
#include "collision_rows.hpp"
#include "exchange.hpp"
#include "gas.hpp"
#include "order.hpp"
#include "scenes.hpp"

namespace carom::page {
namespace {

std::unique_ptr<Gas> the_gas;

/// Rows that are written at a time.
constexpr std::size_t kRowsPerText = 20000;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

template <class Work>
int done(Work&& work) noexcept {
  return guarded(0, [&] {
    work();
    return 1;
  });
}

}  // namespace
}  // namespace carom::page

using namespace carom;
using namespace carom::page;

/// Opens the scene in the input. Returns the number of disks, or −1 with the problems as text.
CAROM_EXPORT int carom_gas_open() {
  return guarded(-1, [] {
    Setup setup = realize(read_scene_text(input()).scene);
    the_gas = std::make_unique<Gas>(std::move(setup));
    return static_cast<int>(the_gas->system().size());
  });
}

CAROM_EXPORT int carom_gas_run_until(double time) {
  return done([&] { the_gas->run_until(time); });
}
CAROM_EXPORT int carom_gas_run_collisions(double collisions) {
  return done([&] { the_gas->run_collisions(static_cast<std::uint64_t>(collisions)); });
}
CAROM_EXPORT int carom_gas_equal_speeds() {
  return done([] { the_gas->equalize_speeds(); });
}
CAROM_EXPORT int carom_gas_reverse() {
  return done([] { the_gas->reverse(); });
}
CAROM_EXPORT int carom_gas_resize(double width, double height) {
  return done([&] { the_gas->resize({width, height}); });
}
CAROM_EXPORT int carom_gas_add_disk(double radius, double mass, double x, double y) {
  return done([&] { the_gas->add_disk({radius, mass}, {x, y}); });
}
CAROM_EXPORT int carom_gas_remove_last_disk() {
  return done([] { the_gas->remove_last_disk(); });
}
CAROM_EXPORT void carom_gas_measure_anew() { the_gas->measure_anew(); }

CAROM_EXPORT double carom_gas_time() { return the_gas->time(); }
CAROM_EXPORT const double* carom_gas_x() { return the_gas->frame().x.data(); }
CAROM_EXPORT const double* carom_gas_y() { return the_gas->frame().y.data(); }
CAROM_EXPORT const double* carom_gas_vx() { return the_gas->frame().vx.data(); }
CAROM_EXPORT const double* carom_gas_vy() { return the_gas->frame().vy.data(); }
CAROM_EXPORT const std::int64_t* carom_gas_winding_x() { return the_gas->frame().winding_x.data(); }
CAROM_EXPORT const std::int64_t* carom_gas_winding_y() { return the_gas->frame().winding_y.data(); }

/// Radius and mass of each disk, one after the other.
CAROM_EXPORT double* carom_gas_kinds() {
  return guarded<double*>(nullptr, [] {
    const System& system = the_gas->system();
    std::vector<double> numbers;
    for (std::size_t k = 0; k < system.size(); ++k) {
      numbers.push_back(system.radius(k));
      numbers.push_back(system.mass(k));
    }
    return answer_numbers(std::move(numbers));
  });
}

/// Time, collisions, contacts with walls since the last restart, kT, kinetic energy, its drift, packing fraction, βP
/// since measuring began anew, largest overlap, width and height of the box, restitution. NaN for what there is not.
CAROM_EXPORT double* carom_gas_summary() {
  return guarded<double*>(nullptr, [] {
    const Gas& gas = *the_gas;
    const Summary summary = gas.summary();
    const Vec2 size = gas.system().box.size;
    return answer_numbers({gas.time(), static_cast<double>(gas.collisions()),
                           static_cast<double>(summary.wall_collisions), summary.temperature.value_or(kNone),
                           kinetic_energy(gas.system(), gas.frame()), summary.energy_drift,
                           summary.packing_fraction.value_or(kNone), gas.pressure().value_or(kNone),
                           summary.max_overlap, size.x, size.y, gas.system().physics.restitution});
  });
}

/// |ψ6| of the whole and then of each disk.
CAROM_EXPORT double* carom_gas_order() {
  return guarded<double*>(nullptr, [] {
    const auto order = hexatic_order(the_gas->system(), the_gas->frame());
    std::complex<double> mean = 0;
    std::vector<double> numbers{0};
    for (const auto& psi : order) {
      mean += psi;
      numbers.push_back(std::abs(psi));
    }
    numbers[0] = std::abs(mean) / static_cast<double>(order.size());
    return answer_numbers(std::move(numbers));
  });
}

CAROM_EXPORT int carom_gas_record(int on) {
  return done([&] { on != 0 ? the_gas->start_recording() : the_gas->stop_recording(); });
}

/// How many contacts are kept, of how many at most, and from which time on.
CAROM_EXPORT double* carom_gas_recorded() {
  return guarded<double*>(nullptr, [] {
    return answer_numbers(
        {static_cast<double>(the_gas->recorded()), static_cast<double>(Recording::kMost), the_gas->recorded_from()});
  });
}

/// Puts the rows of the contacts that are kept, from number `first` on, into the text: so many as it returns, 0 after
/// the last one, −1 with the reason if that fails.
CAROM_EXPORT int carom_gas_recorded_rows(int first) {
  return guarded(-1, [&] {
    const std::vector<Collision> all = the_gas->recorded_collisions();
    const auto begin = std::min(static_cast<std::size_t>(first), all.size());
    const auto count = std::min(kRowsPerText, all.size() - begin);
    answer(collision_rows(std::span(all).subspan(begin, count), 0));
    return static_cast<int>(count);
  });
}

/// Put into the text: the digest of all disks as they are, and the scene that they are.
CAROM_EXPORT int carom_gas_digest() {
  return done([] { answer(the_gas->summary().digest); });
}
CAROM_EXPORT int carom_gas_toml() {
  return done([] { answer(the_gas->to_toml()); });
}
