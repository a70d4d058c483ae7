#include "carom/observe/theory.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom {
namespace {

/// Coefficients of Z = Σ c_k x^k, x = η/(1−η), from k = 0 to 12; two more stand at k = 22 and 57.
constexpr std::array kCoefficients{1.0,          2.0,           1.12801775,   .00181895291, -.0526134737,
                                   .0504960168,  -.0325537792,  .0134578632,  .00140888182, -.00834273601,
                                   .00694127367, -.00262254723, .000355746352};
constexpr double kCoefficient22 = -5.24672938e-9;
constexpr double kCoefficient57 = 5.88054639e-23;

constexpr double kEndOfFluid = 0.7;
constexpr double kSonineFactor = 1.02704;

}  // namespace

std::optional<EqualDisks> gas_of_equal_disks(const System& system) {
  const Box& box = system.box;
  const double area = box.size.x * box.size.y;
  if (box.boundary[0] == Boundary::open || box.boundary[1] == Boundary::open) return std::nullopt;
  const auto disks = static_cast<double>(system.size());
  if (system.species.size() != 1 || disks < kFewestDisks || !(area > 0)) return std::nullopt;
  const EqualDisks gas{.diameter = 2 * system.radius(0),
                       .mass = system.mass(0),
                       .number_density = disks / area,
                       .packing_fraction = packing_fraction(system),
                       .disks = disks};
  return gas.packing_fraction < kEndOfFluid ? std::optional(gas) : std::nullopt;
}

std::optional<EqualDisks> fluid_of_equal_disks(const System& system) {
  const bool periodic = system.box.periodic(0) && system.box.periodic(1);
  return periodic && system.physics.elastic() ? gas_of_equal_disks(system) : std::nullopt;
}

std::optional<TwoDisks> two_disks(const System& system) {
  const Box& box = system.box;
  if (system.size() != 2 || system.species.size() != 1 || !system.physics.elastic()) return std::nullopt;
  const double d = 2 * system.radius(0);
  if (!box.periodic(0) || !box.periodic(1) || std::min(box.size.x, box.size.y) < 2 * d) return std::nullopt;
  const double free = box.size.x * box.size.y - kPi * d * d;
  return TwoDisks{.excess = kPi * d * d / (2 * free), .rate_per = 2 * d / free};
}

double kolafa_rottner(double packing_fraction) {
  const double x = packing_fraction / (1 - packing_fraction);
  double sum = 0;
  for (std::size_t k = kCoefficients.size(); k-- > 0;) sum = sum * x + kCoefficients[k];
  return sum + kCoefficient22 * std::pow(x, 22) + kCoefficient57 * std::pow(x, 57);
}

double contact_value(double packing_fraction) {
  return (kolafa_rottner(packing_fraction) - 1) / (2 * packing_fraction);
}

double enskog_rate(const EqualDisks& gas, double kT) {
  return 2 * gas.number_density * gas.diameter * contact_value(gas.packing_fraction) * std::sqrt(kPi * kT / gas.mass);
}

double enskog_diffusion(const EqualDisks& gas, double kT) {
  const double g = contact_value(gas.packing_fraction);
  return kSonineFactor * std::sqrt(kT / (kPi * gas.mass)) / (2 * gas.number_density * gas.diameter * g);
}

double finite_rate_factor(double degrees_of_freedom) {
  const double half = 0.5 * degrees_of_freedom;
  return std::sqrt(half) * std::exp(std::lgamma(half) - std::lgamma(half + 0.5));
}

}  // namespace carom
