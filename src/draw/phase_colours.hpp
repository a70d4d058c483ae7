// Colours for complex numbers of modulus up to 1: the angle as a hue, the modulus as its strength.
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "ink.hpp"

namespace carom::draw {

inline constexpr std::uint32_t kHues = 60;
inline constexpr std::uint32_t kStrengths = 5;

/// The class that a number belongs to, below kHues × kStrengths.
std::uint32_t phase_class(std::complex<double> value) noexcept;

/// The colours of all classes. Hues go once around a circle of OKLab, evenly; lightness swings once, too, from a light
/// yellow green at one angle to a dark violet opposite, so that angles can be told apart in print without colours and
/// by colour-blind readers. Weak ones are grey.
std::vector<Colour> phase_colours();

/// The circle of colours as a legend: angle 0 to the right, counter-clockwise; modulus 0 in the middle, 1 at the rim.
void draw_phase_wheel(cairo_t* ink, Vec2 centre, double radius);

}  // namespace carom::draw
