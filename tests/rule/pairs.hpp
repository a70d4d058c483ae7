// Pairs as the arrays that a batch takes, and what the rule makes of each of them alone.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/rule/batch.hpp"
#include "carom/rule/collision.hpp"

namespace carom::rule {

inline bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

inline bool same_bits(Vec2 a, Vec2 b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y); }

inline bool same_bits(const Velocities& a, const Velocities& b) {
  return same_bits(a.first, b.first) && same_bits(a.second, b.second);
}

struct Pairs {
  std::vector<double> x1, y1, m1, x2, y2, m2, vx1, vy1, vx2, vy2;

  void add(Vec2 centre1, Vec2 centre2, Velocities v, double mass1, double mass2) {
    x1.push_back(centre1.x), y1.push_back(centre1.y), m1.push_back(mass1);
    x2.push_back(centre2.x), y2.push_back(centre2.y), m2.push_back(mass2);
    vx1.push_back(v.first.x), vy1.push_back(v.first.y);
    vx2.push_back(v.second.x), vy2.push_back(v.second.y);
  }

  [[nodiscard]] std::size_t size() const { return x1.size(); }
  [[nodiscard]] PairSpans spans() { return {x1, y1, m1, x2, y2, m2, vx1, vy1, vx2, vy2}; }
  /// `count` pairs from `first` on.
  [[nodiscard]] PairSpans spans(std::size_t first, std::size_t count) {
    const auto part = [&](std::vector<double>& numbers) { return std::span(numbers).subspan(first, count); };
    return {part(x1), part(y1), part(m1), part(x2), part(y2), part(m2), part(vx1), part(vy1), part(vx2), part(vy2)};
  }

  [[nodiscard]] Velocities velocities(std::size_t k) const { return {{vx1[k], vy1[k]}, {vx2[k], vy2[k]}}; }
  [[nodiscard]] Contact contact(std::size_t k, double restitution) const {
    return {.r = Vec2{x2[k], y2[k]} - Vec2{x1[k], y1[k]},
            .v = velocities(k),
            .m1 = m1[k],
            .m2 = m2[k],
            .restitution = restitution};
  }
  [[nodiscard]] std::vector<Velocities> collided_one_by_one(double restitution) const {
    std::vector<Velocities> after(size());
    for (std::size_t k = 0; k < size(); ++k) after[k] = collide(contact(k, restitution));
    return after;
  }
};

}  // namespace carom::rule
