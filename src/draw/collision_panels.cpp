// The three sketches of a collision.
#include <algorithm>
#include <array>
#include <vector>

#include "collision_sheet.hpp"
#include "labels.hpp"

namespace carom::draw {
namespace {

constexpr double kVisible = 2;     // pixels: shorter arrows are not drawn
constexpr double kBarb = 2;        // pen widths: half the width of an arrow's head
constexpr double kWrongDisk = 40;  // dislike of a label's place

// A panel in the making: labels are collected and placed when all lines are known.
class Panel {
 public:
  Panel(cairo_t* ink, const Sheet& sheet, const Rect& area) : ink_(ink), sheet_(sheet), area_(area) {
    obstacles_.area = area.grown(-4);
  }

  void draw_disks();
  void draw_lines();
  // An arrow from the centre of `disk` with its label, or "label = 0".
  void draw_velocity(int disk, Vec2 v, const Pen& pen, const RichText& label);
  // v with its parts along normal and tangent; names end in `ending`.
  void draw_taken_apart(int disk, Vec2 v, const std::string& ending);
  void draw_labels_and_numbers();

 private:
  [[nodiscard]] Vec2 pixel(Vec2 p) const;
  [[nodiscard]] Vec2 direction(Vec2 d) const { return {d.x, -d.y}; }
  [[nodiscard]] Vec2 centre(int disk) const { return pixel(sheet_.view.disks[disk].centre); }
  [[nodiscard]] double radius(int disk) const { return sheet_.scale * sheet_.view.disks[disk].radius; }
  void draw_axis(const std::array<Vec2, 2>& line, const char* name);
  [[nodiscard]] bool visible(Vec2 v) const { return sheet_.scale * length(v) >= kVisible; }
  void label_zero(int disk, const RichText& label, bool exact, Colour colour);
  // A label inside a disk is taken for that disk's own, unless its arrow ends there.
  void dislike_other_disk(int other, Vec2 tip, Label& label) const;
  void join_tips(Vec2 part, Vec2 whole);
  void label_disk(int disk);

  cairo_t* ink_;
  const Sheet& sheet_;
  Rect area_;
  Obstacles obstacles_;
  std::vector<Label> labels_;
};

Vec2 Panel::pixel(Vec2 p) const {
  const Vec2 middle = 0.5 * (sheet_.view.low + sheet_.view.high);
  return area_.centre() + sheet_.scale * direction(p - middle);
}

void Panel::draw_disks() {
  for (int disk = 0; disk < 2; ++disk) {
    fill_circle(ink_, centre(disk), radius(disk), mix(kDiskColours[disk], kWhite, 0.28));
    obstacles_.circles.push_back({centre(disk), radius(disk), 20});
  }
  for (int disk = 0; disk < 2; ++disk) {
    draw_circle(ink_, centre(disk), radius(disk), {mix(kDiskColours[disk], kBlack, 0.75), 1.6});
  }
}

void Panel::draw_axis(const std::array<Vec2, 2>& line, const char* name) {
  const Vec2 from = pixel(line[0]), to = pixel(line[1]);
  draw_line(ink_, from, to, {kGrey, 1.1, Dash::dashed});
  const Vec2 along = (to - from) / length(to - from);
  draw_arrow(ink_, to - 9 * along, to, {kGrey, 1.6});
  obstacles_.lines.push_back({from, to, 1});
  Label label = make_label(ink_, RichText{}.bold(name), 14, kDarkGrey);
  offer_places_around(label, to, 5, along, 0);
  labels_.push_back(std::move(label));
}

void Panel::draw_lines() {
  draw_axis(sheet_.view.normal_line, "n");
  draw_axis(sheet_.view.tangent_line, "t");
  for (int disk = 0; disk < 2; ++disk) fill_circle(ink_, centre(disk), 2.6, kDarkGrey);
}

void Panel::label_zero(int disk, const RichText& label, bool exact, Colour colour) {
  Label zero = make_label(ink_, RichText(label).plain(exact ? " = 0" : " \u2248 0"), 13, colour);
  offer_places_around(zero, centre(disk), radius(disk) + 5, {0, 1}, 0);
  labels_.push_back(std::move(zero));
}

void Panel::dislike_other_disk(int other, Vec2 tip, Label& label) const {
  if (length(tip - centre(other)) < radius(other)) return;
  for (LabelPlace& place : label.places) {
    if (length(place.centre - centre(other)) < radius(other)) place.dislike += kWrongDisk;
  }
}

void Panel::draw_velocity(int disk, Vec2 v, const Pen& pen, const RichText& text) {
  const Vec2 from = centre(disk), step = sheet_.scale * direction(v);
  if (!visible(v)) return label_zero(disk, text, length(v) <= kRounding, pen.colour);
  draw_arrow(ink_, from, from + step, pen);
  obstacles_.lines.push_back({from, from + step, 4});
  const Vec2 barb = kBarb * pen.width / length(step) * Vec2{-step.y, step.x};
  obstacles_.lines.push_back({from + 0.8 * step - barb, from + 0.8 * step + barb, 4});
  Label label = make_label(ink_, text, 14, pen.colour);
  offer_places_around(label, from + step, 4, step / length(step), 0);
  offer_places_along(label, from, from + step, 6);
  dislike_other_disk(1 - disk, from + step, label);
  labels_.push_back(std::move(label));
}

void Panel::join_tips(Vec2 part, Vec2 whole) {
  draw_line(ink_, pixel(part), pixel(whole), {kGrey, 1, Dash::dotted});
  obstacles_.lines.push_back({pixel(part), pixel(whole), 0.7});
}

void Panel::draw_taken_apart(int disk, Vec2 v, const std::string& ending) {
  const CollisionView& view = sheet_.view;
  const Vec2 along = dot(v, view.normal) * view.normal, across = dot(v, view.tangent) * view.tangent;
  const Pen whole_pen{kVelocityColour, 1.8}, along_pen{kNormalColour, 2.4}, across_pen{kTangentColour, 2.4};
  const RichText whole = vector_name(disk, ending);
  const RichText normal_part = vector_name(disk, "n" + ending), tangential_part = vector_name(disk, "t");
  const auto same = [&](Vec2 rest, const RichText& part) {
    return RichText(whole).plain(length(rest) <= kRounding ? " = " : " \u2248 ").append(part);
  };
  if (!visible(v)) return draw_velocity(disk, v, whole_pen, whole);
  if (!visible(across)) return draw_velocity(disk, along, along_pen, same(across, normal_part));
  if (!visible(along)) return draw_velocity(disk, across, across_pen, same(along, tangential_part));
  const Vec2 from = view.disks[disk].centre;
  join_tips(from + along, from + v);
  join_tips(from + across, from + v);
  draw_velocity(disk, along, along_pen, normal_part);
  draw_velocity(disk, across, across_pen, tangential_part);
  draw_velocity(disk, v, whole_pen, whole);
}

void Panel::label_disk(int disk) {
  const double size = std::clamp(0.5 * radius(disk), 11.0, 17.0);
  Label label = make_label(ink_, RichText{}.bold(disk == 0 ? "1" : "2"), size, mix(kDiskColours[disk], kBlack, 0.45));
  const double inside = radius(disk) > 2.4 * size ? 0.35 * radius(disk) : 3;
  offer_places_around(label, centre(disk), inside, {0, 1}, 0);
  offer_places_around(label, centre(disk), radius(disk) + 4, {0, 1}, 20);
  labels_.push_back(std::move(label));
}

void Panel::draw_labels_and_numbers() {
  for (int disk = 0; disk < 2; ++disk) {
    obstacles_.circles.push_back({centre(disk), 3, 12});
    label_disk(disk);
  }
  draw_labels(ink_, labels_, obstacles_);
}

void draw_frame(cairo_t* ink, const Rect& area, const char* title) {
  draw_text(ink, RichText{}.bold(title), {area.centre().x, area.top - 10}, 15, kBlack, Align::centre);
  draw_rect(ink, area, {kLightGrey, 1});
}

}  // namespace

void draw_panels(cairo_t* ink, const Sheet& sheet) {
  const std::array<const char*, 3> titles{"Before", "Along normal and tangent",
                                          sheet.collision.approaching ? "After" : "After: nothing changes"};
  for (int column = 0; column < 3; ++column) {
    draw_frame(ink, sheet.panel(column), titles[column]);
    Panel panel(ink, sheet, sheet.panel(column));
    panel.draw_disks();
    panel.draw_lines();
    for (int disk = 0; disk < 2; ++disk) {
      const ViewDisk& drawn = sheet.view.disks[disk];
      if (column == 0) panel.draw_velocity(disk, drawn.before, {kVelocityColour, 2.6}, vector_name(disk, ""));
      if (column == 1) panel.draw_taken_apart(disk, drawn.before, "");
      if (column == 2) panel.draw_taken_apart(disk, drawn.after, "f");
    }
    panel.draw_labels_and_numbers();
  }
}

}  // namespace carom::draw
