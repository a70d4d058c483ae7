#include "ideal_pairs.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "carom/base/error.hpp"

namespace carom {
namespace {

// Points of Gauss's rule between kinks: the integrand is a trigonometric polynomial of second degree there.
using Rule = boost::math::quadrature::gauss<double, 15>;
// Where walls leave a disk no room at all, it is taken to have this share of the side.
constexpr double kLeastRoom = 1e-6;

}  // namespace

IdealPairs::Axis IdealPairs::make_axis(const Box& box, int axis, double size, double radius_a, double radius_b) {
  if (box.boundary[axis] == Boundary::open) throw Error("the plane is open: there is no density to compare with");
  if (box.periodic(axis)) return {true, size, size};
  const auto room = [size](double radius) { return std::max(size - 2 * radius, kLeastRoom * size); };
  return {false, room(radius_a), room(radius_b)};
}

IdealPairs::IdealPairs(const Box& box, double radius_a, double radius_b)
    : x_(make_axis(box, 0, box.size.x, radius_a, radius_b)), y_(make_axis(box, 1, box.size.y, radius_a, radius_b)) {}

double IdealPairs::Axis::first_kink() const noexcept { return std::abs(room_a - room_b) / 2; }

double IdealPairs::Axis::common(double u) const noexcept {
  if (periodic) return room_a;
  return u <= first_kink() ? std::min(room_a, room_b) : std::max(0.0, last_kink() - u);
}

double IdealPairs::density(double r) const {
  // Angles at which r cos θ or r sin θ meets a kink divide the quarter turn.
  std::array<double, 6> angles{0, kPi / 2, 0, 0, 0, 0};
  std::size_t count = 2;
  for (const bool along_x : {true, false}) {
    const Axis& axis = along_x ? x_ : y_;
    if (axis.periodic) continue;
    for (const double kink : {axis.first_kink(), axis.last_kink()}) {
      if (kink > 0 && kink < r) angles[count++] = along_x ? std::acos(kink / r) : std::asin(kink / r);
    }
  }
  std::sort(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(count));
  const auto integrand = [&](double angle) { return x_.common(r * std::cos(angle)) * y_.common(r * std::sin(angle)); };
  double integral = 0;
  for (std::size_t k = 0; k + 1 < count; ++k) {
    if (angles[k + 1] > angles[k]) integral += Rule::integrate(integrand, angles[k], angles[k + 1]);
  }
  return 4 * r * integral / (x_.room_a * y_.room_a * x_.room_b * y_.room_b);
}

double IdealPairs::between(double low, double high) const {
  if (x_.periodic && y_.periodic) return kPi * (high - low) * (high + low) / (x_.room_a * y_.room_a);
  return Rule::integrate([this](double r) { return density(r); }, low, high);
}

}  // namespace carom
