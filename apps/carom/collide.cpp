// carom collide: one collision, computed, explained, drawn.
#include <fmt/format.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "carom/carom.hpp"
#include "command.hpp"
#include "options.hpp"
#ifdef CAROM_HAS_DRAW
#include "carom/draw/collision.hpp"
#endif

namespace carom::program {
namespace {

const std::map<std::string, std::optional<ExplainFormat>> kFormats{
    {"text", ExplainFormat::text}, {"markdown", ExplainFormat::markdown}, {"latex", ExplainFormat::latex}};

struct CollideOptions {
  std::vector<std::string> disks;
  double restitution = 1;
  bool advance = false;
  bool explain = false;
  std::optional<ExplainFormat> format;
  std::string svg;
  bool json = false;
  std::string batch;
};

struct GivenDisk {
  Vec2 position;
  Vec2 velocity;
  double mass = 1;
  std::optional<double> radius;
};

GivenDisk parse_disk(const std::string& text) {
  const std::vector<double> n = parse_numbers("--disk", text);
  if (n.size() < 4 || n.size() > 6) {
    throw UsageError(
        fmt::format("--disk {}: give X,Y,VX,VY[,MASS[,RADIUS]], 4 to 6 numbers instead of {}", text, n.size()));
  }
  GivenDisk disk{{n[0], n[1]}, {n[2], n[3]}, 1, std::nullopt};
  if (n.size() > 4) disk.mass = n[4];
  if (n.size() > 5) disk.radius = n[5];
  if (!(disk.mass > 0))
    throw Error(fmt::format("--disk {}: the mass is {}: it must be greater than 0", text, disk.mass));
  if (disk.radius && !(*disk.radius > 0)) {
    throw Error(fmt::format("--disk {}: the radius is {}: it must be greater than 0", text, *disk.radius));
  }
  return disk;
}

/// Two disks where they meet.
struct Meeting {
  GivenDisk first;
  GivenDisk second;
  double time = 0;

  [[nodiscard]] Vec2 r() const noexcept { return second.position - first.position; }
  /// Distance of the centres at contact; the disks must have radii.
  [[nodiscard]] double sigma() const { return *first.radius + *second.radius; }
  [[nodiscard]] rule::Velocities before() const noexcept { return {first.velocity, second.velocity}; }
};

/// Lengths whose squares stay within the range of doubles.
void require_computable(const Meeting& meeting) {
  constexpr double kLargest = 1e75;
  for (const GivenDisk* disk : {&meeting.first, &meeting.second}) {
    for (const double value : {disk->position.x, disk->position.y, disk->velocity.x, disk->velocity.y, disk->mass}) {
      if (std::abs(value) > kLargest)
        throw Error(fmt::format("{} is too large to compute with (over {})", value, kLargest));
    }
    if (disk->radius && !(*disk->radius <= kLargest && *disk->radius >= 1 / kLargest)) {
      throw Error(
          fmt::format("{} is no radius to compute with (under {} or over {})", *disk->radius, 1 / kLargest, kLargest));
    }
    if (disk->mass < 1 / kLargest)
      throw Error(fmt::format("{} is too small a mass to compute with (under {})", disk->mass, 1 / kLargest));
  }
}

void require_line_of_centres(const Meeting& meeting) {
  if (length(meeting.r()) < 1e-75)
    throw Error("the disks have the same centre: there is no line of centres to collide along");
}

void require_contact(const Meeting& meeting) {
  if (!meeting.first.radius) return;
  const double gap = length(meeting.r()) - meeting.sigma();
  if (gap <= kOverlapTolerance * meeting.sigma()) return;
  throw Error(fmt::format(
      "the disks do not touch: their rims are {:.6g} apart; --advance moves them to their first contact", gap));
}

void advance_to_contact(Meeting& meeting) {
  if (!meeting.first.radius) throw UsageError("--advance needs the disks' radii: --disk X,Y,VX,VY,MASS,RADIUS");
  if (length(meeting.r()) <= meeting.sigma()) return;  // they are in contact where they stand
  const predict::Flight a{meeting.first.position, meeting.first.velocity, 0};
  const predict::Flight b{meeting.second.position, meeting.second.velocity, 0};
  const double time = predict::contact_of_disks(a, b, {}, meeting.sigma());
  if (time == predict::kNever) throw Error("the disks do not meet: flying on as they do, they never touch");
  meeting.time = time;
  meeting.first.position = predict::position_at(a, time);
  meeting.second.position = predict::position_at(b, time);
}

/// Far from the origin rounding can be coarser than the disks.
void require_exact_contact(const Meeting& meeting) {
  const double error = std::abs(length(meeting.r()) - meeting.sigma());
  if (meeting.time == 0 || error <= 1e-6 * meeting.sigma()) return;
  throw Error("the disks are too small for their distances: where they meet is lost in rounding");
}

Meeting parse_meeting(const CollideOptions& options) {
  if (options.disks.size() != 2) {
    throw UsageError(
        fmt::format("carom collide needs --disk twice, once for each disk; given: {}", options.disks.size()));
  }
  Meeting meeting{parse_disk(options.disks[0]), parse_disk(options.disks[1]), 0};
  if (meeting.first.radius.has_value() != meeting.second.radius.has_value()) {
    throw UsageError("give a radius to both disks or to neither");
  }
  require_computable(meeting);
  require_line_of_centres(meeting);
  if (options.advance) {
    advance_to_contact(meeting);
    require_exact_contact(meeting);
  } else {
    require_contact(meeting);
  }
  return meeting;
}

rule::Velocities velocities_after(const Meeting& meeting, double restitution) {
  return rule::collide({.r = meeting.r(),
                        .v = meeting.before(),
                        .m1 = meeting.first.mass,
                        .m2 = meeting.second.mass,
                        .restitution = restitution});
}

/// Adding 0 turns −0 into 0.
nlohmann::ordered_json pair_of(Vec2 v) { return {v.x + 0.0, v.y + 0.0}; }

Vec2 momentum_of(const Meeting& meeting, const rule::Velocities& v) {
  return meeting.first.mass * v.first + meeting.second.mass * v.second;
}

double energy_of(const Meeting& meeting, const rule::Velocities& v) {
  return rule::kinetic_energy(meeting.first.mass, v.first) + rule::kinetic_energy(meeting.second.mass, v.second);
}

std::string as_json(const Meeting& meeting, const rule::Velocities& after) {
  const rule::Velocities before = meeting.before();
  const Vec2 un = rule::unit_normal(meeting.first.position, meeting.second.position);
  nlohmann::ordered_json json;
  json["approaching"] = rule::approach(meeting.r(), before) < 0;
  json["normal"] = pair_of(un);
  json["tangent"] = pair_of(rule::unit_tangent(un));
  json["v1n"] = rule::decompose(before.first, un).normal;
  json["v1t"] = rule::decompose(before.first, un).tangential;
  json["v2n"] = rule::decompose(before.second, un).normal;
  json["v2t"] = rule::decompose(before.second, un).tangential;
  json["v1n_after"] = rule::decompose(after.first, un).normal;
  json["v2n_after"] = rule::decompose(after.second, un).normal;
  json["velocity1_after"] = pair_of(after.first);
  json["velocity2_after"] = pair_of(after.second);
  json["momentum_before"] = pair_of(momentum_of(meeting, before));
  json["momentum_after"] = pair_of(momentum_of(meeting, after));
  json["energy_before"] = energy_of(meeting, before);
  json["energy_after"] = energy_of(meeting, after);
  json["impulse"] = pair_of(rule::impulse_on_second(meeting.second.mass, before, after));
  json["equal_masses"] = meeting.first.mass == meeting.second.mass;
  json["time_of_contact"] = meeting.time;
  json["position1"] = pair_of(meeting.first.position);
  json["position2"] = pair_of(meeting.second.position);
  return json.dump(2) + "\n";
}

std::string as_text(const Meeting& meeting, const rule::Velocities& after) {
  const auto vector = [](Vec2 v) { return fmt::format("⟨{:.10g}, {:.10g}⟩", v.x + 0.0, v.y + 0.0); };
  const rule::Velocities before = meeting.before();
  std::string text;
  if (meeting.time > 0) {
    text += fmt::format("The disks meet at time {:.10g}, at {} and {}.\n", meeting.time, vector(meeting.first.position),
                        vector(meeting.second.position));
  }
  if (!(rule::approach(meeting.r(), before) < 0))
    text += "The disks do not approach along the normal: they do not collide.\n";
  text += fmt::format("disk 1: velocity {} before, {} after\n", vector(before.first), vector(after.first));
  text += fmt::format("disk 2: velocity {} before, {} after\n", vector(before.second), vector(after.second));
  text += fmt::format("momentum: {} before, {} after\n", vector(momentum_of(meeting, before)),
                      vector(momentum_of(meeting, after)));
  text += fmt::format("kinetic energy: {:.10g} before, {:.10g} after\n", energy_of(meeting, before),
                      energy_of(meeting, after));
  return text;
}

std::string as_derivation(const Meeting& meeting, const CollideOptions& options) {
  const auto disk = [](const GivenDisk& given) {
    ExplainedDisk explained;
    explained.position = given.position;
    explained.velocity = given.velocity;
    explained.mass = given.mass;
    explained.radius = given.radius;
    return explained;
  };
  ExplainedCollision collision;
  collision.first = disk(meeting.first);
  collision.second = disk(meeting.second);
  collision.restitution = options.restitution;
  collision.time_of_contact = meeting.time;
  return explain(collision, options.format.value_or(ExplainFormat::text));
}

void draw_to(const std::string& path, const Meeting& meeting, const rule::Velocities& after, double restitution) {
#ifdef CAROM_HAS_DRAW
  const double half_distance = 0.5 * length(meeting.r());
  const auto disk = [&](const GivenDisk& given, Vec2 velocity_after) {
    CollisionPicture::Disk drawn;
    drawn.position = given.position;
    drawn.before = given.velocity;
    drawn.after = velocity_after;
    drawn.radius = given.radius.value_or(half_distance);
    drawn.mass = given.mass;
    return drawn;
  };
  CollisionPicture picture;
  picture.first = disk(meeting.first, after.first);
  picture.second = disk(meeting.second, after.second);
  picture.restitution = restitution;
  picture.approaching = rule::approach(meeting.r(), meeting.before()) < 0;
  write_file(path, picture_of_collision(picture, picture_format_of(path)));
#else
  (void)meeting, (void)after, (void)restitution;
  throw Error("cannot draw " + path + ": this carom was built without pictures");
#endif
}

void check_combination(const CollideOptions& options) {
  if (!(options.restitution >= 0 && options.restitution <= 1)) {
    throw Error(fmt::format("--restitution {}: it must lie in [0, 1]", options.restitution));
  }
  if (options.format && !options.explain) throw UsageError("--format goes with --explain");
  if (options.explain && options.json)
    throw UsageError("--explain and --json exclude each other: both print to standard output");
  const bool single =
      !options.disks.empty() || options.advance || options.explain || options.json || !options.svg.empty();
  if (!options.batch.empty() && single) throw UsageError("--batch goes with --restitution only");
}

int collide_command(const CollideOptions& options) {
  check_combination(options);
  if (!options.batch.empty()) {
    const std::string name = options.batch == "-" ? "<stdin>" : options.batch;
    print(collide_batch(read_file(options.batch), name, options.restitution));
    return kSuccess;
  }
  const Meeting meeting = parse_meeting(options);
  const rule::Velocities after = velocities_after(meeting, options.restitution);
  if (!options.svg.empty()) draw_to(options.svg, meeting, after, options.restitution);
  if (options.json) {
    print(as_json(meeting, after));
  } else {
    print(options.explain ? as_derivation(meeting, options) : as_text(meeting, after));
  }
  return kSuccess;
}

}  // namespace

void add_collide(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "collide", "One collision of two disks, explained",
                                  "carom collide --disk 0,0,1,0 --disk 0.6,0.8,0,0 --explain");
  const auto options = std::make_shared<CollideOptions>();
  command
      ->add_option("--disk", options->disks,
                   "X,Y,VX,VY[,MASS[,RADIUS]]: centre, velocity, mass (1) and radius of a disk; give it twice. Without "
                   "radii the disks touch where they stand")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->delimiter('\0')
      ->type_name("DISK");
  add_number(*command, "--restitution", options->restitution, "coefficient of restitution, from 0 to 1 (1)");
  command->add_flag("--advance", options->advance,
                    "first move the disks along their velocities to their first contact");
  command->add_flag("--explain", options->explain, "write out the derivation with these numbers, equation by equation");
  add_choice(*command, "--format", options->format, kFormats, "of --explain: text, markdown or latex");
  add_path(*command, "--svg", options->svg, "FILE", "draw the collision to this file (.svg, .png or .pdf)");
  command->add_flag("--json", options->json, "print one JSON object");
  add_path(*command, "--batch", options->batch, "FILE",
           "read rows x1,y1,vx1,vy1,m1,x2,y2,vx2,vy2,m2 from this CSV file (- for standard input) and print them "
           "with the velocities after");
  command->callback([options, &action] { action = [options] { return collide_command(*options); }; });
}

}  // namespace carom::program
