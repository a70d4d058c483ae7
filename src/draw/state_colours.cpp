#include "state_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "carom/order/local_order.hpp"
#include "phase_colours.hpp"
#include "state_view.hpp"

namespace carom::draw {
namespace {

// In an order in which neighbours differ in lightness: kinds are told apart in print without colours, too.
constexpr std::array<Colour, 7> kSpeciesColours{kSkyBlue, kVermilion, kBlue, kYellow, kGreen, kPurple, kOrange};
constexpr std::uint32_t kShades = 64;

void set_shades(std::string quantity, double low, double high, StateColours& colours) {
  colours.quantity = std::move(quantity);
  colours.low = low;
  colours.high = high;
  for (std::uint32_t shade = 0; shade < kShades; ++shade) {
    colours.classes.push_back(viridis((shade + 0.5) / kShades));
  }
}

std::uint32_t shade_of(double value, const StateColours& colours) {
  const double share = (value - colours.low) / (colours.high - colours.low);
  return share > 0 ? std::min(kShades - 1, static_cast<std::uint32_t>(share * kShades)) : 0;
}

void shade_by_speed(const Frame& frame, const StatePicture& picture, StateColours& colours) {
  set_shades("speed", 0, picture.shared ? picture.shared->largest_speed : largest_speed(frame), colours);
  colours.class_of.reserve(frame.size());
  for (std::size_t k = 0; k < frame.size(); ++k) {
    colours.class_of.push_back(shade_of(std::hypot(frame.vx[k], frame.vy[k]), colours));
  }
}

void shade_by(const System& system, std::string quantity, double Species::*property, StateColours& colours) {
  const auto [low, high] =
      std::minmax_element(system.species.begin(), system.species.end(),
                          [&](const Species& a, const Species& b) { return a.*property < b.*property; });
  set_shades(std::move(quantity), (*low).*property, (*high).*property, colours);
  for (const std::uint32_t species : system.species_of) {
    colours.class_of.push_back(shade_of(system.species[species].*property, colours));
  }
}

void colour_by_species(const System& system, StateColours& colours) {
  if (system.species.size() <= kSpeciesColours.size()) {
    colours.classes.assign(kSpeciesColours.begin(), kSpeciesColours.end());
    colours.class_of = system.species_of;
    return;
  }
  const auto same_radius = [&](const Species& kind) { return kind.radius == system.species.front().radius; };
  if (std::all_of(system.species.begin(), system.species.end(), same_radius)) {
    return shade_by(system, "mass", &Species::mass, colours);
  }
  shade_by(system, "radius", &Species::radius, colours);
}

void shade_by_density(const System& system, const Frame& frame, const StatePicture& picture, StateColours& colours) {
  const std::vector<double> densities = local_order(system, frame).density;
  SharedScale scale;
  if (picture.shared) {
    scale = *picture.shared;
  } else {
    include_densities(densities, scale);
  }
  set_shades("local packing fraction", scale.least_density, scale.greatest_density, colours);
  for (const double density : densities) colours.class_of.push_back(shade_of(density, colours));
}

void colour_by_phase(const System& system, const Frame& frame, StateColours& colours) {
  colours.wheel = true;
  colours.classes = phase_colours();
  for (const std::complex<double> psi6 : local_order(system, frame).psi6) {
    colours.class_of.push_back(phase_class(psi6));
  }
}

}  // namespace

void include_densities(std::vector<double> densities, SharedScale& scale) {
  constexpr double kStep = 0.01;
  const std::size_t few = densities.size() / 50;
  std::sort(densities.begin(), densities.end());
  const double low = kStep * std::floor(densities[few] / kStep);
  const double high = std::max(kStep * std::ceil(densities[densities.size() - 1 - few] / kStep), low + kStep);
  scale.least_density = scale.empty ? low : std::min(scale.least_density, low);
  scale.greatest_density = scale.empty ? high : std::max(scale.greatest_density, high);
}

StateColours colours_of(const System& system, const Frame& frame, const StatePicture& picture) {
  StateColours colours;
  switch (picture.colour) {
    case ColourBy::species: colour_by_species(system, colours); break;
    case ColourBy::speed: shade_by_speed(frame, picture, colours); break;
    case ColourBy::psi6: colour_by_phase(system, frame, colours); break;
    case ColourBy::density: shade_by_density(system, frame, picture, colours); break;
  }
  return colours;
}

}  // namespace carom::draw
