#include "carom/draw/collision.hpp"

#include <fmt/format.h>

#include <cmath>

#include "canvas.hpp"
#include "carom/base/error.hpp"
#include "collision_sheet.hpp"

namespace carom {
namespace {

using namespace draw;

constexpr double kPngScale = 2;  // dots per pixel: sharp in print

std::string title_of(const CollisionPicture& collision) {
  if (!collision.approaching) return "No collision: the disks do not approach each other";
  return collision.restitution == 1 ? "Elastic collision of two disks" : "Inelastic collision of two disks";
}

// What the panels do not show: masses, radii, restitution.
RichText givens(const Sheet& sheet) {
  const CollisionPicture& collision = sheet.collision;
  RichText text;
  text.italic("m").sub("1").plain(" = ").number(collision.first.mass);
  text.plain(",  ").italic("m").sub("2").plain(" = ").number(collision.second.mass);
  text.plain(";   ").italic("r").sub("1").plain(" = ").number(collision.first.radius);
  text.plain(",  ").italic("r").sub("2").plain(" = ").number(collision.second.radius);
  if (!sheet.view.radii_to_scale) text.plain(" (not drawn to scale)");
  if (collision.approaching) text.plain(";   ").italic("e").plain(" = ").number(collision.restitution);
  return text;
}

void refuse_unless(bool good, const std::string& reason) {
  if (!good) throw Error("cannot draw the collision: " + reason);
}

void validate(const CollisionPicture& collision) {
  int number = 1;
  for (const CollisionPicture::Disk* disk : {&collision.first, &collision.second}) {
    const std::string name = fmt::format("disk {}: ", number++);
    for (const Vec2 v : {disk->position, disk->before, disk->after}) {
      refuse_unless(std::isfinite(v.x) && std::isfinite(v.y), name + "position and velocities must be finite numbers");
    }
    refuse_unless(disk->radius > 0 && std::isfinite(disk->radius), name + "the radius must be positive and finite");
    refuse_unless(disk->mass > 0, name + "the mass must be positive");
  }
  const Vec2 r = collision.second.position - collision.first.position;
  refuse_unless(r != Vec2{}, "the centres coincide, so there is no line of centres");
  refuse_unless(std::isfinite(r.x) && std::isfinite(r.y), "the centres are too far apart");
  refuse_unless(collision.restitution >= 0 && collision.restitution <= 1, "restitution must lie in [0, 1]");
}

}  // namespace

std::string picture_of_collision(const CollisionPicture& collision, PictureFormat format) {
  validate(collision);
  CollisionPicture shown = collision;
  if (!shown.approaching) {
    shown.first.after = shown.first.before;
    shown.second.after = shown.second.before;
  }
  const Sheet sheet = sheet_of(shown);
  Canvas canvas(format, sheet.width(), sheet.height(), kPngScale);
  const double middle = 0.5 * sheet.width();
  draw_text(canvas.ink(), RichText{}.bold(title_of(shown)), {middle, 34}, 20, kBlack, Align::centre);
  draw_text(canvas.ink(), givens(sheet), {middle, 60}, 14, kDarkGrey, Align::centre);
  draw_panels(canvas.ink(), sheet);
  draw_numbers(canvas.ink(), sheet);
  return canvas.finish();
}

}  // namespace carom
