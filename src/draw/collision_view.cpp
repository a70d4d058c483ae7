#include "collision_view.hpp"

#include <algorithm>
#include <cmath>

#include "carom/rule/decomposition.hpp"

namespace carom::draw {
namespace {

constexpr double kLargestRatio = 4.5;   // of drawn radii: the smaller disk still holds its number
constexpr double kLongestArrow = 1.3;   // mean radii
constexpr double kInwardShare = 0.92;   // of the centres' distance, for two arrows that point at each other
constexpr double kLineBeyond = 0.35;    // mean radii, of the normal line beyond disks and arrows
constexpr double kTangentReach = 1.45;  // mean radii, to each side of the contact

// Centres drawn this close at most where disks overlap deeply, so that both can be seen (in sums of radii).
constexpr double kClosest = 0.6;

struct Radii {
  double first = 1;
  double second = 1;
  bool to_scale = true;
};

// With mean 1, in the disks' own ratio where that can be drawn.
Radii drawn_radii(double r1, double r2) {
  const double ratio = r1 / r2;
  const double drawn = std::clamp(ratio, 1 / kLargestRatio, kLargestRatio);
  return {2 * drawn / (1 + drawn), 2 / (1 + drawn), drawn == ratio};
}

// Distance of the centres in sums of radii; disks that touch are drawn so, whatever rounding says.
double drawn_distance(const CollisionPicture& collision) {
  const Vec2 r = collision.second.position - collision.first.position;
  const double distance = std::hypot(r.x, r.y) / (collision.first.radius + collision.second.radius);
  return distance > 0.99 ? 1 : std::max(distance, kClosest);
}

double largest_speed(const CollisionPicture& collision) {
  double speed = 0;
  for (const CollisionPicture::Disk* disk : {&collision.first, &collision.second}) {
    for (const Vec2 v : {disk->before, disk->after}) speed = std::max(speed, std::hypot(v.x, v.y));
  }
  return speed;
}

// Arrows from the two centres that point at each other stay apart.
double arrow_length(const CollisionView& view) {
  double inward = 0;
  for (const auto velocity : {&ViewDisk::before, &ViewDisk::after}) {
    inward = std::max(inward, std::max(0.0, dot(view.disks[0].*velocity, view.normal)) +
                                  std::max(0.0, -dot(view.disks[1].*velocity, view.normal)));
  }
  const double room = kInwardShare * length(view.disks[1].centre - view.disks[0].centre);
  return inward * kLongestArrow > room ? room / inward : kLongestArrow;
}

void set_velocities(const CollisionPicture& collision, CollisionView& view) {
  view.speed_scale = largest_speed(collision);
  if (!(view.speed_scale > 0)) return;
  const auto share = [&](Vec2 v) { return Vec2{v.x / view.speed_scale, v.y / view.speed_scale}; };
  view.disks[0].before = share(collision.first.before);
  view.disks[0].after = share(collision.first.after);
  view.disks[1].before = share(collision.second.before);
  view.disks[1].after = share(collision.second.after);
  const double longest = arrow_length(view);
  for (ViewDisk& disk : view.disks) {
    disk.before = longest * disk.before;
    disk.after = longest * disk.after;
  }
}

void place_disks(const CollisionPicture& collision, CollisionView& view) {
  const Radii radii = drawn_radii(collision.first.radius, collision.second.radius);
  const double distance = drawn_distance(collision);
  view.radii_to_scale = radii.to_scale;
  view.disks[0].radius = radii.first;
  view.disks[1].radius = radii.second;
  view.disks[0].centre = -distance * radii.first * view.normal;
  view.disks[1].centre = distance * radii.second * view.normal;
}

// How far along the normal the drawing reaches from the contact, to the side of the disk: rim or arrow.
double normal_reach(const CollisionView& view, const ViewDisk& disk, Vec2 outwards) {
  double reach = dot(disk.centre, outwards) + disk.radius;
  for (const ViewDisk& arrow : view.disks) {
    for (const Vec2 v : {arrow.before, arrow.after}) reach = std::max(reach, dot(arrow.centre + v, outwards));
  }
  return reach;
}

void place_lines(CollisionView& view) {
  const double low = normal_reach(view, view.disks[0], -view.normal) + kLineBeyond;
  const double high = normal_reach(view, view.disks[1], view.normal) + kLineBeyond;
  view.normal_line = {-low * view.normal, high * view.normal};
  view.tangent_line = {-kTangentReach * view.tangent, kTangentReach * view.tangent};
}

void include(CollisionView& view, Vec2 point) {
  view.low = {std::min(view.low.x, point.x), std::min(view.low.y, point.y)};
  view.high = {std::max(view.high.x, point.x), std::max(view.high.y, point.y)};
}

void include_velocity(CollisionView& view, Vec2 centre, Vec2 v) {
  include(view, centre + v);
  include(view, centre + dot(v, view.normal) * view.normal);
  include(view, centre + dot(v, view.tangent) * view.tangent);
}

void set_corners(CollisionView& view) {
  for (const Vec2 end : {view.normal_line[0], view.normal_line[1], view.tangent_line[0], view.tangent_line[1]}) {
    include(view, end);
  }
  for (const ViewDisk& disk : view.disks) {
    const Vec2 corner{disk.radius, disk.radius};
    include(view, disk.centre - corner);
    include(view, disk.centre + corner);
    include_velocity(view, disk.centre, disk.before);
    include_velocity(view, disk.centre, disk.after);
  }
}

}  // namespace

CollisionView view_of(const CollisionPicture& collision) {
  CollisionView view;
  view.normal = rule::unit_normal(collision.first.position, collision.second.position);
  view.tangent = rule::unit_tangent(view.normal);
  place_disks(collision, view);
  set_velocities(collision, view);
  place_lines(view);
  set_corners(view);
  return view;
}

}  // namespace carom::draw
