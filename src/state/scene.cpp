#include "carom/state/scene.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "carom/base/random.hpp"
#include "carom/state/gas.hpp"
#include "carom/state/validate.hpp"

namespace carom {
namespace {

constexpr std::uint32_t kShuffle = 3;   // purpose of the random stream that mixes several gases on one lattice
constexpr std::uint32_t kMixSeeds = 4;  // purpose of the random stream that makes one seed of several
constexpr double kMostIds = 4e9;        // ids are 32 bits wide
constexpr double kBytesPerDisk = 250;   // of a simulation with its first frame, rounded up

/// Realizes one scene step by step, collecting problems; each step runs only if what it needs is sound.
class Realization {
 public:
  explicit Realization(const Scene& scene) : scene_(scene) {}

  void run() {
    check_gas();
    if (problems_.empty()) choose_box();
    if (problems_.empty()) count_gas();
    add_explicit_disks();
    check();
    if (problems_.empty() && !scene_.gas.empty()) {
      add_gas();
      place_gas();
      if (problems_.empty()) check();
    }
    if (problems_.empty()) choose_t_c();
  }

  [[nodiscard]] const std::vector<Problem>& problems() const noexcept { return problems_; }
  [[nodiscard]] Setup& setup() noexcept { return setup_; }

 private:
  void complain(const Place& place, std::string message) { problems_.push_back({std::move(message), place}); }

  static bool positive(double value) noexcept { return std::isfinite(value) && value > 0; }

  void check_gas() {
    for (const GasSpec& gas : scene_.gas) {
      const auto check = [&](std::string_view name, double value) {
        if (!positive(value))
          complain(gas.place, fmt::format("{} of this gas is {}: it must be a number above 0", name, value));
      };
      check("radius", gas.radius);
      check("mass", gas.mass);
      if (!(std::isfinite(gas.temperature) && gas.temperature >= 0)) {
        complain(gas.place,
                 fmt::format("temperature of this gas is {}: it must be a number, 0 or more", gas.temperature));
      }
      if (gas.packing_fraction) check("packing_fraction", *gas.packing_fraction);
      if (gas.count && *gas.count == 0) complain(gas.place, "count of this gas is 0: give at least 1 disk");
      if (gas.count) refuse_too_many(gas, static_cast<double>(*gas.count));
      if (!gas.count && !gas.packing_fraction)
        complain(gas.place, "this gas needs a count, or a packing_fraction in a box with a size");
      if (!gas.count && !scene_.size)
        complain(gas.place, "this gas needs a count: its packing_fraction sets the box, which has no size");
    }
  }

  void refuse_too_many(const GasSpec& gas, double disks) {
    const double most = most_disks();
    if (disks > most)
      complain(gas.place,
               fmt::format("{:.10g} disks are too many: this machine's memory holds about {:.2g}", disks, most));
  }

  void choose_box() {
    Box& box = setup_.system.box;
    box.boundary = scene_.boundary;
    if (scene_.size) {
      box.size = *scene_.size;
      return;
    }
    if (scene_.aspect && !positive(*scene_.aspect)) {
      return complain(scene_.box_place,
                      fmt::format("aspect of the box is {}: it must be a number above 0", *scene_.aspect));
    }
    double covered = 0;
    double fraction = 0;
    for (const GasSpec& gas : scene_.gas) {
      if (!gas.packing_fraction || !gas.count) continue;
      covered += kPi * gas.radius * gas.radius * static_cast<double>(*gas.count);
      fraction += *gas.packing_fraction;
    }
    if (fraction > 0) {
      const double aspect = scene_.aspect.value_or(1);
      const double width = std::sqrt(covered / fraction / aspect);
      box.size = {width, width * aspect};
    } else if (box.boundary != std::array{Boundary::open, Boundary::open} || !scene_.gas.empty()) {
      complain(scene_.box_place, "the box needs a size, or a gas with a packing_fraction that sets it");
    }
  }

  void count_gas() {
    const double area = setup_.system.box.size.x * setup_.system.box.size.y;
    if (!positive(area)) return;  // check() says so, or place_gas()
    double total = 0;
    for (const GasSpec& gas : scene_.gas) {
      double count = 0;
      if (gas.count) {
        count = static_cast<double>(*gas.count);
      } else {
        count = std::rint(*gas.packing_fraction * area / (kPi * gas.radius * gas.radius));
        if (!(count >= 1)) complain(gas.place, "a packing fraction this low leaves no disk in this box");
      }
      total += count;
      refuse_too_many(gas, total);
      if (!problems_.empty()) return;
      gas_count_.push_back(static_cast<std::size_t>(count));
    }
    refuse_impossible_packing(area);
  }

  /// Refuses before a single disk is made what no arrangement can hold. Of few disks place_gas() can tell more.
  void refuse_impossible_packing(double area) {
    constexpr std::size_t kFew = 100'000;
    const double fraction = gas_area() / area;
    if (!(fraction > 1) || std::accumulate(gas_count_.begin(), gas_count_.end(), std::size_t{0}) <= kFew) return;
    complain(
        scene_.gas.front().place,
        fmt::format("a packing fraction of {:.6g} cannot be placed: even the densest lattice of equal disks has {:.4f}",
                    fraction, kPi / std::sqrt(12.0)));
  }

  [[nodiscard]] double gas_area() const {
    double area = 0;
    for (std::size_t g = 0; g < gas_count_.size(); ++g) {
      area += kPi * scene_.gas[g].radius * scene_.gas[g].radius * static_cast<double>(gas_count_[g]);
    }
    return area;
  }

  void add_explicit_disks() {
    setup_.system.physics = {.restitution = scene_.restitution,
                             .wall_restitution = scene_.wall_restitution.value_or(scene_.restitution),
                             .t_c = scene_.t_c.value_or(0)};
    for (const DiskSpec& disk : scene_.disks) {
      setup_.system.add_disk({disk.radius, disk.mass});
      setup_.frame.add_disk(disk.position, disk.velocity);
    }
  }

  void add_gas() {
    for (std::size_t g = 0; g < gas_count_.size(); ++g) {
      for (std::size_t k = 0; k < gas_count_[g]; ++k) {
        setup_.system.add_disk({scene_.gas[g].radius, scene_.gas[g].mass});
        setup_.frame.add_disk({}, {});
      }
    }
  }

  void place_gas() {
    if (gas_count_.empty()) return complain(scene_.box_place, "the box needs a width and a height to hold a gas");
    std::vector<Obstacle> obstacles;
    for (const DiskSpec& disk : scene_.disks) obstacles.push_back({disk.position, disk.radius});
    for (const GasStart start : {GasStart::lattice, GasStart::random}) place_gases_with(start, obstacles);
    if (problems_.empty()) set_gas_velocities();
  }

  /// Places the gases that start in this way, around obstacles; they become obstacles for the next.
  void place_gases_with(GasStart start, std::vector<Obstacle>& obstacles) {
    std::vector<std::size_t> disks;  // ids
    const GasSpec* first_gas = nullptr;
    std::size_t id = scene_.disks.size();
    for (std::size_t g = 0; g < scene_.gas.size(); ++g) {
      const bool takes_part = scene_.gas[g].start == start;
      if (takes_part && first_gas == nullptr) first_gas = &scene_.gas[g];
      for (std::size_t k = 0; k < gas_count_[g]; ++k, ++id) {
        if (takes_part) disks.push_back(id);
      }
    }
    if (disks.empty()) return;

    std::vector<double> radii;
    for (const std::size_t k : disks) radii.push_back(setup_.system.radius(k));
    const Box& box = setup_.system.box;
    const Placement placement =
        start == GasStart::lattice
            ? place_on_lattice(box, disks.size(), *std::max_element(radii.begin(), radii.end()), obstacles)
            : place_at_random(box, radii, seed_of_all(), obstacles);
    if (placement.positions.size() < disks.size())
      return complain(first_gas->place, why_not_placed(start, disks.size(), placement));

    if (start == GasStart::lattice && scene_.gas.size() > 1) shuffle(disks, seed_of_all());
    for (std::size_t k = 0; k < disks.size(); ++k) {
      setup_.frame.x[disks[k]] = placement.positions[k].x;
      setup_.frame.y[disks[k]] = placement.positions[k].y;
      obstacles.push_back({placement.positions[k], setup_.system.radius(disks[k])});
    }
  }

  [[nodiscard]] std::string why_not_placed(GasStart start, std::size_t wanted, const Placement& placement) const {
    const double area = setup_.system.box.size.x * setup_.system.box.size.y;
    const double fraction = gas_area() / area;
    if (start == GasStart::random) {
      const double share = static_cast<double>(placement.positions.size()) / static_cast<double>(wanted);
      return fmt::format(
          "{} of {} disks could be placed at random (packing fraction about {:.3f} of {:.3f}); a random start "
          "reaches about 0.5 with equal disks: use start = \"lattice\"",
          placement.positions.size(), wanted, share * fraction, fraction);
    }
    if (placement.room > 0 && !scene_.size) {
      return fmt::format(
          "{} disks at a packing fraction of {:.4f} do not fit on a lattice in this box: up to {:.4f} can be placed",
          wanted, fraction, std::floor(placement.room * placement.room * fraction * 1e4) / 1e4);
    }
    return fmt::format("{} disks do not fit on a lattice {}: {} can be placed", wanted,
                       scene_.disks.empty() ? "in this box" : "beside the other disks", placement.positions.size());
  }

  /// The first gas's seed, with those of the others mixed in: each of them matters to all.
  [[nodiscard]] std::uint64_t seed_of_all() const {
    std::uint64_t seed = scene_.gas.front().seed;
    for (std::size_t g = 1; g < scene_.gas.size(); ++g) {
      seed = RandomStream(seed, scene_.gas[g].seed, kMixSeeds).bits();
    }
    return seed;
  }

  static void shuffle(std::vector<std::size_t>& ids, std::uint64_t seed) {
    RandomStream random(seed, 0, kShuffle);
    for (std::size_t k = ids.size(); k > 1; --k) std::swap(ids[k - 1], ids[static_cast<std::size_t>(random.below(k))]);
  }

  void set_gas_velocities() {
    std::vector<double> temperatures;
    for (std::size_t g = 0; g < scene_.gas.size(); ++g) {
      temperatures.insert(temperatures.end(), gas_count_[g], scene_.gas[g].temperature);
    }
    draw_velocities(setup_.system, scene_.disks.size(), temperatures, seed_of_all(), setup_.frame);
  }

  /// Validates what there is so far: first the explicit disks alone, then everything.
  void check() {
    Box& box = setup_.system.box;
    const bool box_is_known = scene_.size || box.size != Vec2{};
    const bool nothing_yet = setup_.system.size() == 0 && !scene_.gas.empty();
    if (scene_.size) box = {.size = *scene_.size, .boundary = scene_.boundary};
    if (!box_is_known) box.boundary = {Boundary::open, Boundary::open};
    for (const Finding& finding : validate(setup_.system, setup_.frame)) {
      if (nothing_yet && finding.about == Finding::About::disks) continue;
      complain(place_of(finding), finding.message);
    }
  }

  [[nodiscard]] Place place_of(const Finding& finding) const {
    switch (finding.about) {
      case Finding::About::box: return scene_.box_place;
      case Finding::About::physics: return scene_.physics_place;
      case Finding::About::disks: break;
    }
    return finding.disk && *finding.disk < scene_.disks.size() ? scene_.disks[*finding.disk].place : Place{};
  }

  void choose_t_c() {
    Physics& physics = setup_.system.physics;
    if (!scene_.t_c && !physics.elastic()) physics.t_c = default_t_c(setup_.system, setup_.frame);
  }

  const Scene& scene_;
  Setup setup_;
  std::vector<std::size_t> gas_count_;
  std::vector<Problem> problems_;
};

}  // namespace

double most_disks() noexcept {
  const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::min(kMostIds, memory / kBytesPerDisk);
}

Setup realize(const Scene& scene) {
  Realization realization(scene);
  realization.run();
  if (!realization.problems().empty()) throw Error(realization.problems());
  return std::move(realization.setup());
}

std::vector<Problem> problems_of(const Scene& scene) {
  Realization realization(scene);
  realization.run();
  return realization.problems();
}

double default_t_c(const System& system, const Frame& frame) noexcept {
  const auto count = static_cast<double>(system.size());
  double diameters = 0;
  double squares = 0;
  for (std::size_t k = 0; k < system.size(); ++k) {
    diameters += 2 * system.radius(k);
    squares += dot(frame.velocity(k), frame.velocity(k));
  }
  return squares > 0 ? 1e-6 * (diameters / count) / std::sqrt(squares / count) : 0;
}

State initial_state(const Setup& setup) {
  State state;
  state.disks = setup.frame;
  state.disks.time = 0;
  std::fill(state.disks.winding_x.begin(), state.disks.winding_x.end(), 0);
  std::fill(state.disks.winding_y.begin(), state.disks.winding_y.end(), 0);
  const Box& box = setup.system.box;
  for (std::size_t k = 0; k < state.disks.size(); ++k) {
    if (box.periodic(0)) state.disks.x[k] = wrap(state.disks.x[k], box.size.x).coordinate;
    if (box.periodic(1)) state.disks.y[k] = wrap(state.disks.y[k], box.size.y).coordinate;
  }
  if (!setup.system.physics.elastic()) {
    state.last_contact.assign(state.disks.size(), -std::numeric_limits<double>::infinity());
  }
  return state;
}

}  // namespace carom
