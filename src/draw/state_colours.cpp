#include "state_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "state_view.hpp"

namespace carom::draw {
namespace {

constexpr std::array<Colour, 7> kSpeciesColours{kSkyBlue, kOrange, kGreen, kVermilion, kBlue, kYellow, kPurple};
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

void shade_by_speed(const Frame& frame, StateColours& colours) {
  set_shades("speed", 0, largest_speed(frame), colours);
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

}  // namespace

StateColours colours_of(const System& system, const Frame& frame, ColourBy colour) {
  StateColours colours;
  if (colour == ColourBy::speed) {
    shade_by_speed(frame, colours);
  } else {
    colour_by_species(system, colours);
  }
  return colours;
}

}  // namespace carom::draw
