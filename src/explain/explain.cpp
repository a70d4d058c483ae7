#include "carom/explain/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "carom/base/error.hpp"
#include "carom/rule/collision.hpp"
#include "derivation.hpp"

namespace carom {
namespace {

using explaining::Decimal;
using explaining::Derivation;

constexpr int kFewestDigits = 8;
constexpr int kMostDigits = 16;

void require(bool holds, std::string_view what, double value, std::string_view reason) {
  if (!holds) throw Error(fmt::format("{} {} {}", what, value, reason));
}

void check(std::string_view name, const ExplainedDisk& disk) {
  const auto finite = [&](std::string_view what, double value) {
    require(std::isfinite(value), fmt::format("{}: {}", name, what), value, "is not a finite number");
  };
  finite("x", disk.position.x);
  finite("y", disk.position.y);
  finite("velocity along x", disk.velocity.x);
  finite("velocity along y", disk.velocity.y);
  finite("mass", disk.mass);
  require(disk.mass > 0, fmt::format("{}: mass", name), disk.mass, "is not positive");
  if (!disk.radius) return;
  finite("radius", *disk.radius);
  require(*disk.radius > 0, fmt::format("{}: radius", name), *disk.radius, "is not positive");
}

rule::Contact contact_of(const ExplainedCollision& collision) {
  rule::Contact contact;
  contact.r = collision.second.position - collision.first.position;
  contact.v = {collision.first.velocity, collision.second.velocity};
  contact.m1 = collision.first.mass;
  contact.m2 = collision.second.mass;
  contact.restitution = collision.restitution;
  return contact;
}

void check(const ExplainedCollision& collision) {
  check("disk 1", collision.first);
  check("disk 2", collision.second);
  const double e = collision.restitution;
  require(e >= 0 && e <= 1, "restitution", e, "is not between 0 and 1");
  const double time = collision.time_of_contact;
  require(std::isfinite(time) && time >= 0, "time of contact", time, "is not a finite number from 0 on");
  const Vec2 r = contact_of(collision).r;
  const double distance = std::hypot(r.x, r.y);
  if (distance == 0)
    throw Error(fmt::format("disk 1 and disk 2 both have their centre at ({}, {}): there is no normal",
                            collision.first.position.x, collision.first.position.y));
  require(distance >= 1e-150 && distance <= 1e150, "disk 1 and disk 2: the distance of their centres", distance,
          "is not between 1e-150 and 1e150");
}

rule::Velocities after_in_double_precision(const ExplainedCollision& collision) {
  const rule::Velocities after = rule::collide(contact_of(collision));
  for (const double v : {after.first.x, after.first.y, after.second.x, after.second.y})
    require(std::isfinite(v), "velocity after the collision", v, "is beyond double precision");
  return after;
}

// The sign of v·r of the given decimal numbers, without rounding.
bool approaches_exactly(const ExplainedCollision& collision) {
  const auto difference = [](double a, double b) {
    return Decimal(explaining::decimal_of(b) - explaining::decimal_of(a));
  };
  const ExplainedDisk& one = collision.first;
  const ExplainedDisk& two = collision.second;
  return difference(one.position.x, two.position.x) * difference(one.velocity.x, two.velocity.x) +
             difference(one.position.y, two.position.y) * difference(one.velocity.y, two.velocity.y) <
         0;
}

// Whether the printed velocities are those of double precision, to six digits of the largest speed.
bool agrees(const Derivation& derivation, const rule::Velocities& after) {
  const std::array doubles = {after.first.x, after.first.y, after.second.x, after.second.y};
  Decimal largest = 0;
  Decimal difference = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    largest = std::max(largest, Decimal(abs(Decimal(doubles[k]))));
    difference = std::max(difference, Decimal(abs(derivation.after[k] - Decimal(doubles[k]))));
  }
  return difference <= largest * Decimal("5e-7");
}

std::string json_vector(Vec2 v) { return fmt::format("[{}, {}]", v.x + 0.0, v.y + 0.0); }  // + 0.0: no -0

explaining::Step in_double_precision(const rule::Velocities& after, bool agreed) {
  using namespace explaining;
  Step step{"In double precision", {}};
  step.blocks.emplace_back(Paragraph{{"The velocities after, as ", Code{"carom collide --json"},
                                      " gives them, from the impulse form of the same rule:"}});
  step.blocks.emplace_back(
      Listing{{"velocity1_after: " + json_vector(after.first), "velocity2_after: " + json_vector(after.second)}});
  if (!agreed)
    step.blocks.emplace_back(
        Paragraph{{"They differ from those above by more than the sixth digit: the given numbers differ too little, or "
                   "are too far apart in size, for double precision to hold what the calculation needs."}});
  return step;
}

}  // namespace

std::string explain(const ExplainedCollision& collision, ExplainFormat format) {
  check(collision);
  const rule::Velocities after = after_in_double_precision(collision);
  const bool approaches = approaches_exactly(collision);
  Derivation derivation;
  bool agreed = false;
  for (int digits = kFewestDigits; digits <= kMostDigits; ++digits) {
    derivation = explaining::derive(collision, digits);
    agreed = agrees(derivation, after);
    if (agreed && derivation.balanced && derivation.approaching == approaches) break;
  }
  derivation.document.steps.push_back(in_double_precision(after, agreed));
  switch (format) {
    case ExplainFormat::text: return explaining::text_of(derivation.document);
    case ExplainFormat::markdown: return explaining::markdown_of(derivation.document);
    case ExplainFormat::latex: return explaining::latex_of(derivation.document);
  }
  throw Error("unknown format of an explanation");
}

}  // namespace carom
