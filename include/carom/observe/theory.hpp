// What theory says of the gas of equal disks, for comparison with what is measured.
#pragma once

#include <optional>
#include <string_view>

#include "carom/state/system.hpp"

namespace carom {

/// Fewer disks are no gas that theory could be held against.
inline constexpr double kFewestDisks = 50;

/// A gas of equal disks.
struct EqualDisks {
  double diameter = 1;
  double mass = 1;
  double number_density = 0;    ///< N/A (1/length²)
  double packing_fraction = 0;  ///< η
  double disks = 0;             ///< N
};

/// The system as a gas of at least kFewestDisks equal elastic disks, if it is one in the fluid range (η < 0.7) of a
/// periodic box, where the functions below hold but for the size; else nothing.
std::optional<EqualDisks> fluid_of_equal_disks(const System& system);
/// The same for any restitution and boundary without an open axis: for what holds at a start, or approximately.
std::optional<EqualDisks> gas_of_equal_disks(const System& system);

/// Compressibility factor Z = βP/ρ of the infinite system (Kolafa and Rottner, Mol. Phys. 104, 3435 (2006)).
double kolafa_rottner(double packing_fraction);

/// Z of N disks in a periodic box, to the first order in 1/N: that of the infinite system − (η/2N) u″/u′ with u = ηZ
/// (Lebowitz and Percus, Phys. Rev. 122, 1675 (1961)). Above η = 0.65, where the transition is near and the expansion
/// fails, that of the infinite system.
double finite_compressibility(const EqualDisks& gas);
/// Whose Z that is, for a theory_source.
std::string_view source_of_compressibility(const EqualDisks& gas);

/// Contact value g of the pair distribution, from Z = 1 + 2 η g.
double contact_value(double packing_fraction);
/// The same of N disks in a periodic box, from finite_compressibility.
double finite_contact_value(const EqualDisks& gas);

/// Collisions per disk and time of the infinite system, Γ = 2 ρ d g √(π kT/m) (Enskog).
double enskog_rate(const EqualDisks& gas, double kT);
/// The same of N disks in a periodic box of f degrees of freedom and given energy: with finite_contact_value and C.
double finite_rate(const EqualDisks& gas, double kT, double degrees_of_freedom);

/// Self-diffusion D = √(kT/(π m))/(2 ρ d g) × 1.02704 (length²/time): Enskog's first Sonine approximation times the
/// factor to which the expansion converges.
double enskog_diffusion(const EqualDisks& gas, double kT);

/// Two equal elastic disks in a periodic box, both sides at least 2 d: exact, for their relative motion is that of a
/// point among round obstacles, with a mean free path of (A − π d²)/(2 d).
struct TwoDisks {
  double excess = 0;    ///< Z − 1 = π d²/(2 (A − π d²)), with kT = 2E/f
  double rate_per = 0;  ///< collisions per time are this times the relative speed √(4 kT/m) (1/length)
};
/// Nothing if the system is another.
std::optional<TwoDisks> two_disks(const System& system);

/// C = √(f/2) Γ(f/2)/Γ((f+1)/2): by which a system of f degrees of freedom and given energy collides more often than at
/// the temperature kT = 2E/f of a heat bath. Tends to 1 for large f.
double finite_rate_factor(double degrees_of_freedom);

}  // namespace carom
