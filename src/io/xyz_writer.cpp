#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "carom/io/xyz.hpp"
#include "numbers.hpp"

namespace carom {
namespace {

using Buffer = fmt::memory_buffer;

/// Programs for molecules, ASE among them, take chemical elements only.
constexpr auto kSymbols = std::to_array<std::string_view>(
    {"H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si", "P",  "S",  "Cl",
     "Ar", "K",  "Ca", "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga", "Ge", "As", "Se",
     "Br", "Kr", "Rb", "Sr", "Y",  "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag", "Cd", "In", "Sn", "Sb",
     "Te", "I",  "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd", "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er",
     "Tm", "Yb", "Lu", "Hf", "Ta", "W",  "Re", "Os", "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At",
     "Rn", "Fr", "Ra", "Ac", "Th", "Pa", "U",  "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No",
     "Lr", "Rf", "Db", "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og"});

/// A symbol for each of the first 118 kinds; "X", no element, for all others.
std::string species_name(std::size_t index) { return std::string(index < kSymbols.size() ? kSymbols[index] : "X"); }

/// A stretch along one axis.
struct Stretch {
  double low = 0;
  double length = 0;
};

/// Along an open axis a box may have no size.
bool box_bounds(int axis, const Box& box) noexcept {
  return box.boundary[axis] != Boundary::open || (axis == 0 ? box.size.x : box.size.y) > 0;
}

/// The box along one axis or, where nothing bounds it, what the disks cover.
Stretch stretch_along(int axis, const System& system, const Frame& frame) {
  const double size = axis == 0 ? system.box.size.x : system.box.size.y;
  if (box_bounds(axis, system.box) || frame.size() == 0) return {0, size};
  const std::vector<double>& centres = axis == 0 ? frame.x : frame.y;
  double low = centres[0] - system.radius(0);
  double high = centres[0] + system.radius(0);
  for (std::size_t k = 1; k < centres.size(); ++k) {
    low = std::min(low, centres[k] - system.radius(k));
    high = std::max(high, centres[k] + system.radius(k));
  }
  return {low, high - low};
}

template <typename... Arguments>
void append(Buffer& buffer, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(buffer), format, std::forward<Arguments>(arguments)...);
}

void append_key(Buffer& buffer, std::string_view key, double value) {
  append(buffer, " {}=", key);
  io::append_17_digits(buffer, value);
}

void append_lattice(Buffer& buffer, const System& system, const Frame& frame) {
  const Stretch x = stretch_along(0, system, frame);
  const Stretch y = stretch_along(1, system, frame);
  append(buffer, "Lattice=\"{:.17g} 0.0 0.0 0.0 {:.17g} 0.0 0.0 0.0 {:.17g}\"", x.length, y.length,
         2 * system.largest_radius());
  if (x.low != 0 || y.low != 0) append(buffer, " Origin=\"{:.17g} {:.17g} 0.0\"", x.low, y.low);
}

void append_comment(Buffer& buffer, const System& system, const Frame& frame) {
  const Box& box = system.box;
  append_lattice(buffer, system, frame);
  append(buffer, " Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1");
  append_key(buffer, "Time", frame.time);
  append(buffer, " pbc=\"{} {} F\"", box.periodic(0) ? 'T' : 'F', box.periodic(1) ? 'T' : 'F');
  append(buffer, " boundary=\"{} {}\"", name_of(box.boundary[0]), name_of(box.boundary[1]));
  const bool has_open_axis = box.boundary[0] == Boundary::open || box.boundary[1] == Boundary::open;
  if (has_open_axis) append(buffer, " box=\"{:.17g} {:.17g}\"", box.size.x, box.size.y);
  const Physics& physics = system.physics;
  if (!physics.elastic()) {
    append_key(buffer, "restitution", physics.restitution);
    append_key(buffer, "wall_restitution", physics.wall_restitution);
  }
  if (physics.t_c != 0) append_key(buffer, "t_c", physics.t_c);
}

/// What is the same in every row of a species: its name, and its radius and mass.
struct SpeciesText {
  std::string name;
  std::string radius_and_mass;
};

std::vector<SpeciesText> species_texts(const System& system) {
  std::vector<SpeciesText> texts;
  for (const Species& kind : system.species) {
    texts.push_back({species_name(texts.size()), fmt::format(" {:.17g} {:.17g} ", kind.radius, kind.mass)});
  }
  return texts;
}

}  // namespace

std::string xyz_frame(const System& system, const Frame& frame) {
  Buffer buffer;
  append(buffer, "{}\n", frame.size());
  append_comment(buffer, system, frame);
  append(buffer, "\n");
  const std::vector<SpeciesText> species = species_texts(system);
  for (std::size_t k = 0; k < frame.size(); ++k) {
    const SpeciesText& kind = species[system.species_of[k]];
    append(buffer, "{} {:.17g} {:.17g} 0 {:.17g} {:.17g} 0{}{}\n", kind.name, frame.x[k], frame.y[k], frame.vx[k],
           frame.vy[k], kind.radius_and_mass, k);
  }
  return fmt::to_string(buffer);
}

}  // namespace carom
