#include "carom/state/state.hpp"

#include <cmath>
#include <limits>

#include "carom/base/digest.hpp"

namespace carom {
namespace {

void add_frame(Digest& digest, const Frame& frame) {
  digest.add(frame.time);
  for (std::size_t k = 0; k < frame.size(); ++k) {
    for (const double value : {frame.x[k], frame.y[k], frame.vx[k], frame.vy[k]}) digest.add(value);
    for (const std::int64_t value : {frame.winding_x[k], frame.winding_y[k]}) digest.add(value);
  }
}

}  // namespace

void Frame::resize(std::size_t count) {
  for (auto* column : {&x, &y, &vx, &vy}) column->resize(count);
  for (auto* column : {&winding_x, &winding_y}) column->resize(count);
}

void Frame::add_disk(Vec2 position, Vec2 velocity) {
  x.push_back(position.x);
  y.push_back(position.y);
  vx.push_back(velocity.x);
  vy.push_back(velocity.y);
  winding_x.push_back(0);
  winding_y.push_back(0);
}

Wrapped wrap(double coordinate, double period) noexcept {
  const double turns = std::floor(coordinate / period);
  const double folded = coordinate - period * turns;
  if (folded >= period) return {0, static_cast<std::int64_t>(turns) + 1};
  return {folded, static_cast<std::int64_t>(turns)};
}

double kinetic_energy(const System& system, const Frame& frame) noexcept {
  double sum = 0;
  for (std::size_t k = 0; k < frame.size(); ++k)
    sum += 0.5 * system.mass(k) * dot(frame.velocity(k), frame.velocity(k));
  return sum;
}

Vec2 momentum(const System& system, const Frame& frame) noexcept {
  Vec2 sum;
  for (std::size_t k = 0; k < frame.size(); ++k) sum = sum + system.mass(k) * frame.velocity(k);
  return sum;
}

double momentum_scale(const System& system, const Frame& frame) noexcept {
  double sum = 0;
  for (std::size_t k = 0; k < frame.size(); ++k) sum += system.mass(k) * length(frame.velocity(k));
  return sum;
}

double temperature(const System& system, const Frame& frame) noexcept {
  const double freedom = degrees_of_freedom(system);
  if (!(freedom > 0)) return std::numeric_limits<double>::quiet_NaN();
  double mass = 0;
  for (std::size_t k = 0; k < frame.size(); ++k) mass += system.mass(k);
  const Vec2 mean = momentum(system, frame) / mass;
  const Vec2 drift{system.box.conserves_momentum(0) ? mean.x : 0, system.box.conserves_momentum(1) ? mean.y : 0};
  double twice_energy = 0;
  for (std::size_t k = 0; k < frame.size(); ++k) {
    const Vec2 v = frame.velocity(k) - drift;
    twice_energy += system.mass(k) * dot(v, v);
  }
  return twice_energy / freedom;
}

std::string digest(const Frame& frame) {
  Digest digest;
  add_frame(digest, frame);
  return digest.hex();
}

std::string digest(const System& system, const Frame& frame) {
  Digest digest;
  const Box& box = system.box;
  for (const double value : {box.size.x, box.size.y}) digest.add(value);
  for (const Boundary boundary : box.boundary) digest.add(static_cast<std::int64_t>(boundary));
  const Physics& physics = system.physics;
  for (const double value : {physics.restitution, physics.wall_restitution, physics.t_c}) digest.add(value);
  for (std::size_t k = 0; k < system.size(); ++k) {
    for (const double value : {system.radius(k), system.mass(k)}) digest.add(value);
  }
  add_frame(digest, frame);
  return digest.hex();
}

}  // namespace carom
