// The numbers below the sketches of a collision.
#include <array>
#include <cmath>

#include "carom/rule/decomposition.hpp"
#include "collision_sheet.hpp"

namespace carom::draw {
namespace {

constexpr double kLineSpacing = 24;

class Numbers {
 public:
  Numbers(cairo_t* ink, const Sheet& sheet) : ink_(ink), sheet_(sheet) {}
  void draw();

 private:
  void write(int column, int row, const RichText& text, Colour colour = kBlack);
  // Rounding of the largest speed is not shown as a number.
  [[nodiscard]] double speed(double v) const { return std::abs(v) <= kRounding * sheet_.view.speed_scale ? 0 : v; }
  [[nodiscard]] Vec2 velocity(Vec2 v) const { return {speed(v.x), speed(v.y)}; }
  [[nodiscard]] RichText parts(int disk, Vec2 v, const std::string& ending) const;
  void draw_colour_key();

  cairo_t* ink_;
  const Sheet& sheet_;
};

void Numbers::write(int column, int row, const RichText& text, Colour colour) {
  const Rect area = sheet_.panel(column);
  draw_text(ink_, text, {area.left + 6, area.bottom + 28 + row * kLineSpacing}, 13, colour);
}

RichText Numbers::parts(int disk, Vec2 v, const std::string& ending) const {
  const rule::Parts parts = rule::decompose(v, sheet_.view.normal);
  RichText text = size_name(disk, "n" + ending);
  text.plain(" = ").number(speed(parts.normal)).plain(",   ").append(size_name(disk, "t"));
  return text.plain(" = ").number(speed(parts.tangential));
}

void Numbers::draw_colour_key() {
  struct Entry {
    Colour colour;
    const char* name;
  };
  constexpr std::array<Entry, 3> kEntries{
      {{kVelocityColour, "velocity"}, {kNormalColour, "along normal"}, {kTangentColour, "along tangent"}}};
  const Rect area = sheet_.panel(1);
  double x = area.left + 6;
  const double y = area.bottom + 28 + 3 * kLineSpacing;
  for (const Entry& entry : kEntries) {
    const RichText text = RichText{}.plain(entry.name);
    draw_arrow(ink_, {x, y - 4.5}, {x + 24, y - 4.5}, {entry.colour, 2.4});
    draw_text(ink_, text, {x + 30, y}, 12, kDarkGrey);
    x += 30 + measure(ink_, text, 12).x + 16;
  }
}

void Numbers::draw() {
  const std::array<const CollisionPicture::Disk*, 2> disks{&sheet_.collision.first, &sheet_.collision.second};
  for (int disk = 0; disk < 2; ++disk) {
    write(0, disk, vector_name(disk, "").plain(" = ").vector(velocity(disks[disk]->before)));
    write(1, disk, parts(disk, disks[disk]->before, ""));
    write(2, disk, vector_name(disk, "f").plain(" = ").vector(velocity(disks[disk]->after)));
    write(2, disk + 2, parts(disk, disks[disk]->after, "f"));
  }
  write(0, 2, RichText{}.bold("n").plain(" = ").vector(sheet_.view.normal).plain("  (unit normal)"));
  write(0, 3, RichText{}.bold("t").plain(" = ").vector(sheet_.view.tangent).plain("  (unit tangent)"));
  draw_colour_key();
}

}  // namespace

void draw_numbers(cairo_t* ink, const Sheet& sheet) { Numbers(ink, sheet).draw(); }

}  // namespace carom::draw
