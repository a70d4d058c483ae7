#include "phase_colours.hpp"

#include <algorithm>
#include <cmath>

#include "carom/state/system.hpp"

namespace carom::draw {
namespace {

constexpr double kLightness = 0.70;
constexpr double kLightnessSwing = 0.16;
constexpr double kLightestAngle = 2.0;  // radians of the hue: a light yellow green
constexpr double kChroma = 0.125;

double encoded(double linear) {
  const double value = std::clamp(linear, 0.0, 1.0);
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
}

// OKLab (Ottosson 2020) as sRGB, cut off where the screen ends.
Colour colour_of_oklab(double lightness, double a, double b) {
  const auto cube = [](double value) { return value * value * value; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Colour colour_of(double angle, double modulus) {
  const double strength = std::pow(modulus, 0.6);  // the disks of a dense fluid have moduli around 0.7: not to be grey
  const double lightness = kLightness + strength * kLightnessSwing * std::cos(angle - kLightestAngle);
  return colour_of_oklab(lightness, strength * kChroma * std::cos(angle), strength * kChroma * std::sin(angle));
}

}  // namespace

std::uint32_t phase_class(std::complex<double> value) noexcept {
  const double turn = std::arg(value) / (2 * kPi);
  const auto hue = static_cast<std::uint32_t>(std::clamp((turn - std::floor(turn)) * kHues, 0.0, kHues - 1.0));
  const auto strength = static_cast<std::uint32_t>(std::clamp(std::abs(value) * kStrengths, 0.0, kStrengths - 1.0));
  return hue * kStrengths + strength;
}

std::vector<Colour> phase_colours() {
  std::vector<Colour> colours;
  for (std::uint32_t hue = 0; hue < kHues; ++hue) {
    for (std::uint32_t strength = 0; strength < kStrengths; ++strength) {
      colours.push_back(colour_of(2 * kPi * (hue + 0.5) / kHues, (strength + 0.5) / (kStrengths - 0.5)));
    }
  }
  return colours;
}

void draw_phase_wheel(cairo_t* ink, Vec2 centre, double radius) {
  const std::vector<Colour> colours = phase_colours();
  constexpr double kOverlap = 0.02;  // radians: no white shows between the sectors
  for (std::uint32_t strength = kStrengths; strength-- > 0;) {
    const double rim = radius * (strength + 1) / kStrengths;
    for (std::uint32_t hue = 0; hue < kHues; ++hue) {
      const double begin = 2 * kPi * hue / kHues, end = 2 * kPi * (hue + 1) / kHues + (hue + 1 < kHues ? kOverlap : 0);
      cairo_new_path(ink);
      cairo_move_to(ink, centre.x, centre.y);
      cairo_arc_negative(ink, centre.x, centre.y, rim, -begin, -end);
      cairo_close_path(ink);
      set_colour(ink, colours[hue * kStrengths + strength]);
      cairo_fill(ink);
    }
  }
  draw_circle(ink, centre, radius, {kDarkGrey, 0.8});
}

}  // namespace carom::draw
