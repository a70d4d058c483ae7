#include "derivation.hpp"

#include <tuple>
#include <utility>

#include "balance.hpp"
#include "ledger.hpp"
#include "symbols.hpp"

namespace carom::explaining {
namespace {

// Writes the document step by step; each method is one step.
class Author {
 public:
  Author(const ExplainedCollision& collision, int digits) : collision_(collision), ledger_(digits) {}

  Derivation write();

 private:
  void given();
  void normal_and_tangent();
  void projections();
  bool approach();
  void no_collision();
  void elastic_collision_on_line();
  void inelastic_collision_on_line();
  void tangential_parts();
  void vectors();
  void equations_a_to_d();
  void summary();

  Row row_of(const std::string& label, const DiskSymbols& of, const ExplainedDisk& disk);
  void compare_with_radii();
  void after_equations_5_and_6();
  void equation(const std::string& tag, const Expr& component, const Expr& numerator);

  [[nodiscard]] bool elastic() const { return collision_.restitution == 1; }
  [[nodiscard]] bool equal_masses() const { return collision_.first.mass == collision_.second.mass; }

  void step(std::string heading) { document_.steps.push_back({std::move(heading), {}}); }
  void add(Block block) { document_.steps.back().blocks.push_back(std::move(block)); }
  void say(std::vector<Run> runs) { add(Paragraph{std::move(runs)}); }

  const ExplainedCollision& collision_;
  Ledger ledger_;
  Document document_{"The collision of two disks, step by step", {}};
  Symbols s_;
  bool differently_rounded_ = false;  // A–D differ from the vectors in the last digits shown
};

Row Author::row_of(const std::string& label, const DiskSymbols& of, const ExplainedDisk& disk) {
  Row row{label, {ledger_.give(of.m, disk.mass)}};
  if (disk.radius) row.chains.push_back(ledger_.give(of.radius, *disk.radius));
  const bool computed = collision_.time_of_contact > 0;
  const Chain x = computed ? ledger_.give_rounded(of.x, disk.position.x) : ledger_.give(of.x, disk.position.x);
  const Chain y = computed ? ledger_.give_rounded(of.y, disk.position.y) : ledger_.give(of.y, disk.position.y);
  Chain place = statement(point(of.x, of.y), ledger_.with_numbers(point(of.x, of.y)));
  if (x.members.back().relation == Relation::about || y.members.back().relation == Relation::about)
    place.members.back().relation = Relation::about;
  row.chains.push_back(place);
  ledger_.give(of.vx, disk.velocity.x);
  ledger_.give(of.vy, disk.velocity.y);
  row.chains.push_back(ledger_.derive(of.v, {}, vector(of.vx, of.vy)));
  return row;
}

void Author::given() {
  step("What is given");
  say({"Masses, centres at the moment of contact, and velocities before the collision, in any consistent units:"});
  add(row_of("Disk 1", s_.one, collision_.first));
  add(row_of("Disk 2", s_.two, collision_.second));
  const Chain restitution = ledger_.give(s_.e, collision_.restitution);
  if (collision_.time_of_contact > 0) {
    const Chain time = ledger_.give_rounded(s_.time, collision_.time_of_contact);
    say({"Both fly straight and with constant velocity until they touch at the time ", time,
         "; the centres above are those at this moment."});
  }
  if (elastic()) {
    say({"The collision is elastic (restitution ", restitution, "): kinetic energy is kept."});
  } else {
    say({"The restitution is ", restitution, ": the collision is not elastic, kinetic energy is lost."});
  }
  say({"Below, ", symbol("=", "="), " is exact and ", symbol("≈", "\\approx"),
       " means rounded to " + std::to_string(ledger_.digits()) +
           " significant digits. Every line uses the numbers as they are printed above it."});
}

void Author::normal_and_tangent() {
  step("The normal and the tangent");
  say({"The normal runs from the centre of disk 1 to the centre of disk 2:"});
  add(ledger_.derive(s_.dx, {}, s_.two.x - s_.one.x));
  add(ledger_.derive(s_.dy, {}, s_.two.y - s_.one.y));
  add(ledger_.derive(s_.n, {}, vector(s_.dx, s_.dy)));
  add(ledger_.derive(s_.distance, {}, root(square(s_.dx) + square(s_.dy))));
  compare_with_radii();
  say({"The unit normal is the normal divided by its length:"});
  add(ledger_.derive(s_.un, {vector(s_.unx, s_.uny)}, vector(s_.dx / s_.distance, s_.dy / s_.distance)));
  say({"The tangent is perpendicular to the normal. Divided by the same length it is the unit tangent:"});
  add(ledger_.derive(s_.t, {}, vector(-s_.dy, s_.dx)));
  add(ledger_.derive(s_.ut, {vector(s_.utx, s_.uty)}, vector(-s_.dy / s_.distance, s_.dx / s_.distance)));
}

void Author::compare_with_radii() {
  if (!collision_.first.radius || !collision_.second.radius) return;
  const Expr sum = s_.one.radius + s_.two.radius;
  const Chain reach = ledger_.derive(sum, {}, sum);
  add(reach);
  const Decimal& radii = reach.members.back().expression->number.value;
  const Decimal gap = (ledger_.value(s_.distance) - radii) / radii;
  if (abs(gap) <= Decimal("1e-6")) {
    say({"The distance of the centres is the sum of the radii: the disks touch."});
  } else if (gap < 0) {
    say(
        {"The centres are closer than the sum of the radii: the disks overlap. The normal is the line of centres all "
         "the same."});
  } else {
    say(
        {"The centres are farther apart than the sum of the radii: the disks do not touch yet. What follows takes the "
         "normal as they stand."});
  }
}

void Author::projections() {
  step("The velocities along the normal and the tangent");
  say({"The dot product with a unit vector is the part of a velocity in its direction, a number with a sign:"});
  for (const DiskSymbols* disk : {&s_.one, &s_.two}) {
    add(ledger_.derive(disk->vn, {dot(s_.un, disk->v)}, s_.unx * disk->vx + s_.uny * disk->vy));
    add(ledger_.derive(disk->vt, {dot(s_.ut, disk->v)}, s_.utx * disk->vx + s_.uty * disk->vy));
  }
}

bool Author::approach() {
  step("Do they approach?");
  const Expr speed = s_.one.vn - s_.two.vn;
  Chain chain = ledger_.derive(speed, {}, speed);
  const Decimal value = chain.members.back().expression->number.value;
  if (value != 0) chain.members.push_back({value > 0 ? Relation::greater : Relation::less, Expr(0)});
  say({"The distance of the centres shrinks at the rate"});
  add(chain);
  if (value > 0) say({"This is positive: the disks approach, so they collide."});
  if (value < 0) say({"This is negative: the disks move apart already. They do not collide."});
  if (value == 0) say({"The distance does not change: the disks at most slide along each other. They do not collide."});
  return value > 0;
}

void Author::no_collision() {
  step("The velocities stay");
  say({"Without a collision there is no impulse, and both disks keep their velocities:"});
  for (const DiskSymbols* disk : {&s_.one, &s_.two}) {
    add(ledger_.derive(disk->vf, {disk->v}, vector(disk->vx, disk->vy)));
    ledger_.derive(vector(disk->vfx, disk->vfy), {}, vector(disk->vx, disk->vy));
  }
}

void Author::elastic_collision_on_line() {
  const auto& [one, two] = std::tie(s_.one, s_.two);
  step("The collision along the normal");
  say(
      {"Along the normal the disks collide head-on, as on a straight line. Momentum is kept (equation 1), and so is "
       "kinetic energy (equation 2):"});
  add(statement(one.m * one.vn + two.m * two.vn, one.m * one.vnf + two.m * two.vnf, "1"));
  add(statement(one.m * square(one.vn) / 2 + two.m * square(two.vn) / 2,
                one.m * square(one.vnf) / 2 + two.m * square(two.vnf) / 2, "2"));
  say({"Sorted by disks, and (2) multiplied by 2:"});
  add(statement(one.m * (one.vn - one.vnf), two.m * (two.vnf - two.vn), "3"));
  add(statement(one.m * (square(one.vn) - square(one.vnf)), two.m * (square(two.vnf) - square(two.vn)), "4"));
  say({"Dividing (4) by (3) leaves ", statement(one.vn + one.vnf, two.vnf + two.vn), ". Put into (3), this gives:"});
  after_equations_5_and_6();
}

void Author::after_equations_5_and_6() {
  const auto& [one, two] = std::tie(s_.one, s_.two);
  const Expr total = one.m + two.m;
  const Expr five = (2 * one.m * one.vn + (two.m - one.m) * two.vn) / total;
  const Expr six = ((one.m - two.m) * one.vn + 2 * two.m * two.vn) / total;
  if (!equal_masses()) {
    add(tagged("5", ledger_.derive(two.vnf, {}, five)));
    add(tagged("6", ledger_.derive(one.vnf, {}, six)));
    say({"(The source text prints ", one.m - two.m, " in its line for ", two.vnf, " in two dimensions; it has to be ",
         two.m - one.m, ", as in its own equation 5.)"});
    return;
  }
  // In one step: rounding on the way would hide that the velocities are exchanged exactly.
  add(tagged("5", ledger_.derive_at_once(two.vnf, {}, five)));
  add(tagged("6", ledger_.derive_at_once(one.vnf, {}, six)));
  say({"The masses are equal: their difference vanishes, and the disks exchange their normal velocities:"});
  add(ledger_.derive(two.vnf, {}, one.vn));
  add(ledger_.derive(one.vnf, {}, two.vn));
}

void Author::inelastic_collision_on_line() {
  const auto& [one, two] = std::tie(s_.one, s_.two);
  step("The collision along the normal");
  say(
      {"Along the normal the disks collide head-on, as on a straight line. Momentum is kept (equation 1, sorted by "
       "disks equation 3):"});
  add(statement(one.m * one.vn + two.m * two.vn, one.m * one.vnf + two.m * two.vnf, "1"));
  add(statement(one.m * (one.vn - one.vnf), two.m * (two.vnf - two.vn), "3"));
  say({"Kinetic energy is not kept, so equations 2 and 4 do not hold. In their place, the disks separate with ", s_.e,
       " times the speed at which they approached:"});
  add(statement(two.vnf - one.vnf, s_.e * (one.vn - two.vn)));
  say({"The two together give, in place of equations 5 and 6 (which they become for ", statement(s_.e, 1), "):"});
  const Expr approach = one.vn - two.vn;
  const Expr total = one.m + two.m;
  add(ledger_.derive(two.vnf, {}, two.vn + (1 + s_.e) * one.m * approach / total));
  add(ledger_.derive(one.vnf, {}, one.vn - (1 + s_.e) * two.m * approach / total));
  say({"The kinetic energy that is lost:"});
  add(ledger_.derive(s_.lost, {}, one.m * two.m * (1 - square(s_.e)) * square(approach) / (2 * total)));
}

void Author::tangential_parts() {
  step("The tangential parts stay");
  say({"The disks are smooth: no friction acts along the tangent, so nothing changes there."});
  for (const DiskSymbols* disk : {&s_.one, &s_.two}) add(ledger_.derive(disk->vtf, {}, disk->vt));
}

void Author::vectors() {
  step("Back to vectors");
  for (const DiskSymbols* disk : {&s_.one, &s_.two}) {
    say({disk == &s_.one ? "Disk 1: the new normal part times the unit normal, the tangential part times the unit "
                           "tangent, and their sum:"
                         : "Disk 2:"});
    add(ledger_.derive(vector(disk->vnfx, disk->vnfy), {disk->vnf * s_.un},
                       vector(disk->vnf * s_.unx, disk->vnf * s_.uny)));
    add(ledger_.derive(vector(disk->vtx, disk->vty), {disk->vt * s_.ut}, vector(disk->vt * s_.utx, disk->vt * s_.uty)));
    add(ledger_.derive(disk->vf, {vector(disk->vfx, disk->vfy)},
                       vector(disk->vnfx + disk->vtx, disk->vnfy + disk->vty)));
  }
}

// One of A–D. Its result takes the place of the component found before: it went through fewer roundings.
void Author::equation(const std::string& tag, const Expr& component, const Expr& numerator) {
  const Decimal before = ledger_.value(component);
  add(tagged(tag, ledger_.derive(component, {}, numerator / (square(s_.dx) + square(s_.dy)))));
  if (ledger_.value(component) != before) differently_rounded_ = true;
}

void Author::equations_a_to_d() {
  step("The same at once: equations A to D");
  say({"For equal masses everything fits into four formulas, without a square root:"});
  const auto component_x = [this](const DiskSymbols& own, const DiskSymbols& other) {
    return other.vx * square(s_.dx) + other.vy * s_.dx * s_.dy + own.vx * square(s_.dy) - own.vy * s_.dx * s_.dy;
  };
  const auto component_y = [this](const DiskSymbols& own, const DiskSymbols& other) {
    return other.vx * s_.dx * s_.dy + other.vy * square(s_.dy) - own.vx * s_.dy * s_.dx + own.vy * square(s_.dx);
  };
  equation("A", s_.one.vfx, component_x(s_.one, s_.two));
  equation("B", s_.one.vfy, component_y(s_.one, s_.two));
  equation("C", s_.two.vfx, component_x(s_.two, s_.one));
  equation("D", s_.two.vfy, component_y(s_.two, s_.one));
  say({differently_rounded_
           ? "These are the velocities found above, up to the rounding of the numbers shown. These went "
             "through fewer roundings, so the check takes them:"
           : "These are the velocities found above:"});
  for (const DiskSymbols* disk : {&s_.one, &s_.two}) add(ledger_.derive(disk->vf, {}, vector(disk->vfx, disk->vfy)));
}

Derivation Author::write() {
  given();
  normal_and_tangent();
  projections();
  Derivation result;
  result.approaching = approach();
  if (result.approaching) {
    elastic() ? elastic_collision_on_line() : inelastic_collision_on_line();
    tangential_parts();
    vectors();
    if (elastic() && equal_masses()) equations_a_to_d();
    Balance balance = balance_of(s_, ledger_, elastic());
    result.balanced = balance.holds;
    document_.steps.push_back(std::move(balance.step));
  } else {
    no_collision();
  }
  result.after = {ledger_.value(s_.one.vfx), ledger_.value(s_.one.vfy), ledger_.value(s_.two.vfx),
                  ledger_.value(s_.two.vfy)};
  result.document = std::move(document_);
  return result;
}

}  // namespace

Derivation derive(const ExplainedCollision& collision, int digits) { return Author(collision, digits).write(); }

}  // namespace carom::explaining
