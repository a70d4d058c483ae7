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
constexpr double kEndOfExpansion = 0.65;
constexpr double kSonineFactor = 1.02704;

/// A function of one variable with its first two derivatives.
struct Expansion {
  double value = 0;
  double slope = 0;
  double curvature = 0;

  void add_power(double coefficient, double x, int k) {
    value += coefficient * std::pow(x, k);
    slope += coefficient * k * std::pow(x, k - 1);
    curvature += coefficient * k * (k - 1) * std::pow(x, k - 2);
  }
};

/// Z as a function of x.
Expansion kolafa_rottner_in_x(double x) {
  Expansion z;
  for (std::size_t k = 0; k < kCoefficients.size(); ++k) z.add_power(kCoefficients[k], x, static_cast<int>(k));
  z.add_power(kCoefficient22, x, 22);
  z.add_power(kCoefficient57, x, 57);
  return z;
}

bool holds_expansion(const EqualDisks& gas) { return gas.packing_fraction <= kEndOfExpansion; }

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
  return kolafa_rottner_in_x(packing_fraction / (1 - packing_fraction)).value;
}

double finite_compressibility(const EqualDisks& gas) {
  const double eta = gas.packing_fraction;
  const double x = eta / (1 - eta);
  const Expansion z = kolafa_rottner_in_x(x);
  if (!holds_expansion(gas)) return z.value;
  const double dx = (1 + x) * (1 + x);  // dx/dη; d²x/dη² is 2 (1 + x)³
  const double slope = z.slope * dx;
  const double curvature = z.curvature * dx * dx + 2 * z.slope * dx * (1 + x);
  return z.value - eta / (2 * gas.disks) * (2 * slope + eta * curvature) / (z.value + eta * slope);
}

std::string_view source_of_compressibility(const EqualDisks& gas) {
  return holds_expansion(gas) ? "Kolafa and Rottner 2006, at this N" : "Kolafa and Rottner 2006, infinite system";
}

double contact_value(double packing_fraction) {
  return (kolafa_rottner(packing_fraction) - 1) / (2 * packing_fraction);
}

double finite_contact_value(const EqualDisks& gas) {
  return (finite_compressibility(gas) - 1) / (2 * gas.packing_fraction);
}

double enskog_rate(const EqualDisks& gas, double kT) {
  return 2 * gas.number_density * gas.diameter * contact_value(gas.packing_fraction) * std::sqrt(kPi * kT / gas.mass);
}

double finite_rate(const EqualDisks& gas, double kT, double degrees_of_freedom) {
  const double size_effect = finite_contact_value(gas) / contact_value(gas.packing_fraction);
  return enskog_rate(gas, kT) * size_effect * finite_rate_factor(degrees_of_freedom);
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
