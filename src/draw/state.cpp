#include "carom/draw/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "canvas.hpp"
#include "carom/base/error.hpp"
#include "carom/order/local_order.hpp"
#include "state_colours.hpp"
#include "state_disks.hpp"
#include "state_footer.hpp"
#include "state_view.hpp"

namespace carom {
namespace {

using namespace draw;

constexpr double kMargin = 20;
constexpr double kTitleHeight = 30;
constexpr double kTitleSize = 18;
constexpr double kLeastWidth = 200;
constexpr double kGreatestWidth = 8000;
constexpr double kLeastTextWidth = 300;  // of the lines below a narrow box
constexpr double kWall = 4;              // pixels

void refuse_unless(bool good, const std::string& reason) {
  if (!good) throw Error("cannot draw the state: " + reason);
}

void validate(const System& system, const Frame& frame, const StatePicture& picture) {
  refuse_unless(frame.size() > 0, "there are no disks");
  refuse_unless(frame.size() == system.size(),
                fmt::format("the system has {} disks, the frame {}", system.size(), frame.size()));
  refuse_unless(picture.width_px >= kLeastWidth && picture.width_px <= kGreatestWidth,
                fmt::format("the width must lie between {} and {} pixels", kLeastWidth, kGreatestWidth));
  for (int axis = 0; axis < 2; ++axis) {
    const double size = axis == 0 ? system.box.size.x : system.box.size.y;
    refuse_unless(system.box.boundary[axis] == Boundary::open || (size > 0 && std::isfinite(size)),
                  "the box has no size");
  }
  for (std::size_t k = 0; k < frame.size(); ++k) {
    const bool finite = std::isfinite(frame.x[k]) && std::isfinite(frame.y[k]) && std::isfinite(frame.vx[k]) &&
                        std::isfinite(frame.vy[k]) && std::isfinite(system.radius(k));
    refuse_unless(finite, fmt::format("disk {}: position, velocity and radius must be finite numbers", k));
  }
}

// One side of the box: a thick line outside for a wall, dashes for a periodic edge, nothing where it is open.
void draw_side(cairo_t* ink, Boundary boundary, Vec2 from, Vec2 to, Vec2 outwards) {
  if (boundary == Boundary::periodic) draw_line(ink, from, to, {kGrey, 1, Dash::dashed});
  if (boundary != Boundary::reflecting) return;
  const Vec2 along = 0.5 * kWall / length(to - from) * (to - from);  // the corners are closed
  const Vec2 shift = 0.5 * kWall * outwards;
  draw_line(ink, from - along + shift, to + along + shift, {kDarkGrey, kWall});
}

void draw_box(cairo_t* ink, const Box& box, const Rect& area) {
  const Vec2 top_left{area.left, area.top}, top_right{area.right, area.top};
  const Vec2 bottom_left{area.left, area.bottom}, bottom_right{area.right, area.bottom};
  draw_side(ink, box.boundary[0], top_left, bottom_left, {-1, 0});
  draw_side(ink, box.boundary[0], top_right, bottom_right, {1, 0});
  draw_side(ink, box.boundary[1], bottom_left, bottom_right, {0, 1});
  draw_side(ink, box.boundary[1], top_left, top_right, {0, -1});
}

}  // namespace

void include_in_scale(const System& system, const Frame& frame, const StatePicture& picture, SharedScale& scale) {
  validate(system, frame, picture);
  if (picture.colour == ColourBy::density) include_densities(local_order(system, frame).density, scale);
  for (std::size_t k = 0; k < frame.size(); ++k) {
    const Vec2 centre = frame.position(k), reach{system.radius(k), system.radius(k)};
    const Vec2 low = centre - reach, high = centre + reach;
    const bool first = scale.empty && k == 0;
    scale.low = first ? low : Vec2{std::min(scale.low.x, low.x), std::min(scale.low.y, low.y)};
    scale.high = first ? high : Vec2{std::max(scale.high.x, high.x), std::max(scale.high.y, high.y)};
  }
  scale.largest_speed = std::max(scale.largest_speed, largest_speed(frame));
  scale.empty = false;
}

std::string picture_of_state(const System& system, const Frame& frame, const StatePicture& picture,
                             PictureFormat format) {
  validate(system, frame, picture);
  const double top = kMargin + (picture.title.empty() ? 0 : kTitleHeight);
  const StateView view = view_of(system, frame, picture, kMargin, top);
  const StateColours colours = colours_of(system, frame, picture);

  // Text can be measured only on a canvas, and the canvas's size depends on the text: a small one measures.
  const Canvas ruler(PictureFormat::png, 1, 1, 1);
  const double title_width = measure(ruler.ink(), RichText{}.bold(printable(picture.title)), kTitleSize).x;
  const double widest = picture.width_px - 2 * kMargin;
  const double text_width = std::min(widest, std::max({view.area.width(), kLeastTextWidth, title_width}));
  const Footer footer = footer_of(ruler.ink(), system, frame, picture, view, colours, text_width);

  Canvas canvas(format, std::ceil(text_width + 2 * kMargin),
                std::ceil(view.area.bottom + footer.height + 0.5 * kMargin), 1);
  if (!picture.title.empty()) {
    draw_text(canvas.ink(), RichText{}.bold(printable(picture.title)), {kMargin, kMargin + 12}, kTitleSize, kBlack);
  }
  draw_disks(canvas.ink(), system, frame, view, colours);
  draw_box(canvas.ink(), system.box, view.area);
  draw_footer(canvas.ink(), footer, {kMargin, view.area.bottom}, text_width, colours);
  return canvas.finish();
}

}  // namespace carom
