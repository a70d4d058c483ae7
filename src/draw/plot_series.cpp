#include "plot_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>

namespace carom::draw {
namespace {

constexpr std::size_t kMostMarks = 60;
constexpr std::size_t kThinned = 4000;  // points: lines of more are drawn by their extremes per column of pixels
constexpr double kMark = 3;             // pixels: radius
constexpr double kCap = 3;              // pixels: half the width of an error bar's ends
constexpr double kLine = 1.6;
constexpr double kFar = 1e5;  // pixels: what lies beyond is drawn there, short of the range of Cairo's numbers

constexpr std::array kPalette{kBlue, kVermilion, kGreen, kPurple, kOrange, kSkyBlue};

Vec2 kept_near(Vec2 p) { return {std::clamp(p.x, -kFar, kFar), std::clamp(p.y, -kFar, kFar)}; }

double error_at(const Series& series, std::size_t k) {
  const double error = series.error.empty() ? 0 : series.error[k];
  return std::isfinite(error) && error > 0 ? error : 0;
}

// The pixel at `y`, or at the foot of the panel where a logarithmic axis has no place for it.
Vec2 pixel_or_foot(const PanelView& view, double x, double y) {
  if (view.y.has_place(y)) return kept_near(view.pixel(x, y));
  return {kept_near(view.pixel(x, std::pow(10, view.y.low()))).x, kFar};
}

// Calls `draw` with [begin, end) for every run of points that have a place.
void for_each_stretch(const PanelView& view, const Series& series,
                      const std::function<void(std::size_t begin, std::size_t end)>& draw) {
  std::size_t begin = 0;
  for (std::size_t k = 0; k <= series.x.size(); ++k) {
    const bool there = k < series.x.size() && view.has_place(series.x[k], series.y[k]);
    if (there) continue;
    if (k > begin) draw(begin, k);
    begin = k + 1;
  }
}

// The points of a line; where there are very many, only the extremes of each column of pixels.
std::vector<Vec2> line_through(const PanelView& view, const Series& series, std::size_t begin, std::size_t end) {
  std::vector<Vec2> points;
  const bool thin = end - begin > kThinned;
  std::optional<double> column;
  for (std::size_t k = begin; k < end; ++k) {
    const Vec2 p = kept_near(view.pixel(series.x[k], series.y[k]));
    const double here = std::floor(2 * p.x);
    if (!thin || column != here) {
      points.insert(points.end(), thin ? 2 : 1, p);
      column = here;
      continue;
    }
    Vec2& top = points[points.size() - 2];
    Vec2& foot = points.back();
    if (p.y < top.y) top = p;
    if (p.y > foot.y) foot = p;
  }
  return points;
}

void trace(cairo_t* ink, const std::vector<Vec2>& points) {
  for (const Vec2 p : points) cairo_line_to(ink, p.x, p.y);
}

void draw_curve(cairo_t* ink, const PanelView& view, const Series& series, const Pen& pen) {
  for_each_stretch(view, series, [&](std::size_t begin, std::size_t end) {
    cairo_new_path(ink);
    if (end - begin == 1) {
      const Vec2 p = kept_near(view.pixel(series.x[begin], series.y[begin]));
      return fill_circle(ink, p, pen.width, pen.colour);
    }
    trace(ink, line_through(view, series, begin, end));
    stroke_path(ink, pen);
  });
}

void draw_band(cairo_t* ink, const PanelView& view, const Series& series, Colour colour) {
  if (series.error.empty()) return;
  for_each_stretch(view, series, [&](std::size_t begin, std::size_t end) {
    cairo_new_path(ink);
    for (std::size_t k = begin; k < end; ++k) {
      const Vec2 p = pixel_or_foot(view, series.x[k], series.y[k] + error_at(series, k));
      cairo_line_to(ink, p.x, p.y);
    }
    for (std::size_t k = end; k-- > begin;) {
      const Vec2 p = pixel_or_foot(view, series.x[k], series.y[k] - error_at(series, k));
      cairo_line_to(ink, p.x, p.y);
    }
    cairo_close_path(ink);
    set_colour(ink, mix(colour, kWhite, 0.3));
    cairo_fill(ink);
  });
}

void draw_error_bar(cairo_t* ink, Vec2 top, Vec2 foot, const Pen& pen) {
  draw_line(ink, top, foot, pen);
  for (const Vec2 end : {top, foot}) draw_line(ink, end - Vec2{kCap, 0}, end + Vec2{kCap, 0}, pen);
}

void draw_error_bars(cairo_t* ink, const PanelView& view, const Series& series, Colour colour) {
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    const double error = error_at(series, k);
    if (error == 0 || !view.has_place(series.x[k], series.y[k])) continue;
    draw_error_bar(ink, pixel_or_foot(view, series.x[k], series.y[k] + error),
                   pixel_or_foot(view, series.x[k], series.y[k] - error), {colour, 1.2});
  }
}

// Marks of one area, whatever their shape.
void draw_mark(cairo_t* ink, Vec2 at, const Look& look) {
  const auto polygon = [&](std::initializer_list<Vec2> corners) {
    cairo_new_path(ink);
    for (const Vec2 corner : corners) cairo_line_to(ink, at.x + kMark * corner.x, at.y + kMark * corner.y);
    cairo_close_path(ink);
    set_colour(ink, look.colour);
    cairo_fill(ink);
  };
  switch (look.mark) {
    case Look::Mark::circle: return fill_circle(ink, at, kMark, look.colour);
    case Look::Mark::square: return polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case Look::Mark::triangle: return polygon({{0, -1.4}, {1.25, 0.8}, {-1.25, 0.8}});
    case Look::Mark::diamond: return polygon({{0, -1.35}, {1.2, 0}, {0, 1.35}, {-1.2, 0}});
  }
}

void draw_marks(cairo_t* ink, const PanelView& view, const Series& series, const Look& look) {
  draw_error_bars(ink, view, series, look.colour);
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    if (!view.has_place(series.x[k], series.y[k])) continue;
    draw_mark(ink, kept_near(view.pixel(series.x[k], series.y[k])), look);
  }
}

void draw_bars(cairo_t* ink, const PanelView& view, const Series& series, Colour colour) {
  const std::vector<double> edges = edges_of_bars(series.x);
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    if (!view.has_place(series.x[k], series.y[k]) || !view.x.has_place(edges[k]) || !view.x.has_place(edges[k + 1]))
      continue;
    const Vec2 top = kept_near(view.pixel(edges[k], series.y[k]));
    const Vec2 foot = pixel_or_foot(view, edges[k + 1], 0);
    const Rect bar{top.x, std::min(top.y, foot.y), foot.x, std::max(top.y, foot.y)};
    fill_rect(ink, bar, mix(colour, kWhite, 0.35));
    if (series.x.size() <= kMostMarks) draw_rect(ink, bar, {colour, 0.8});
  }
  if (series.x.size() <= kMostMarks) draw_error_bars(ink, view, series, mix(colour, kBlack, 0.7));
}

Pen pen_of_theory(Colour colour) { return {colour, 1.4, Dash::dashed}; }

}  // namespace

std::vector<double> edges_of_bars(const std::vector<double>& x) {
  if (x.empty()) return {};
  if (x.size() == 1) return {x[0] - 0.5, x[0] + 0.5};
  std::vector<double> edges;
  edges.push_back(x[0] - 0.5 * (x[1] - x[0]));
  for (std::size_t k = 1; k < x.size(); ++k) edges.push_back(0.5 * x[k - 1] + 0.5 * x[k]);
  edges.push_back(x.back() + 0.5 * (x.back() - x[x.size() - 2]));
  return edges;
}

bool drawn_as_marks(const Series& series) noexcept {
  return series.style == Series::Style::measured && series.x.size() <= kMostMarks;
}

std::vector<Look> looks_of(const std::vector<Series>& series) {
  constexpr std::array kMarks{Look::Mark::circle, Look::Mark::square, Look::Mark::triangle, Look::Mark::diamond};
  const auto measured =
      std::count_if(series.begin(), series.end(), [](const Series& one) { return one.style != Series::Style::theory; });
  std::vector<Look> looks;
  std::size_t next = 0;
  for (const Series& one : series) {
    if (one.style != Series::Style::theory) {
      looks.push_back({kPalette[next % kPalette.size()], kMarks[next % kMarks.size()]});
      ++next;
    } else {
      const bool belongs = measured > 1 && next > 0;
      looks.push_back({belongs ? mix(kPalette[(next - 1) % kPalette.size()], kBlack, 0.55) : kBlack});
    }
  }
  return looks;
}

void draw_series(cairo_t* ink, const PanelView& view, const std::vector<Series>& series,
                 const std::vector<Look>& looks) {
  using Style = Series::Style;
  const auto each = [&](const auto& draw) {
    for (std::size_t k = 0; k < series.size(); ++k) draw(series[k], looks[k]);
  };
  cairo_save(ink);
  cairo_rectangle(ink, view.area.left, view.area.top, view.area.width(), view.area.height());
  cairo_clip(ink);
  cairo_set_line_join(ink, CAIRO_LINE_JOIN_ROUND);
  each([&](const Series& one, const Look& look) {
    if (one.style == Style::bars) draw_bars(ink, view, one, look.colour);
    if (one.style == Style::measured && !drawn_as_marks(one)) draw_band(ink, view, one, look.colour);
  });
  each([&](const Series& one, const Look& look) {
    if (one.style == Style::measured && !drawn_as_marks(one)) draw_curve(ink, view, one, {look.colour, kLine});
  });
  each([&](const Series& one, const Look& look) {
    if (one.style == Style::theory) draw_curve(ink, view, one, pen_of_theory(look.colour));
  });
  each([&](const Series& one, const Look& look) {
    if (drawn_as_marks(one)) draw_marks(ink, view, one, look);
  });
  cairo_restore(ink);
}

void draw_sample(cairo_t* ink, const Series& series, const Look& look, Vec2 left) {
  const Vec2 right = left + Vec2{kSampleWidth, 0}, middle = left + Vec2{0.5 * kSampleWidth, 0};
  const Rect box{left.x + 4, left.y - 5, right.x - 4, left.y + 5};
  const bool errors = !series.error.empty();
  switch (series.style) {
    case Series::Style::theory: return draw_line(ink, left, right, pen_of_theory(look.colour));
    case Series::Style::bars:
      fill_rect(ink, box, mix(look.colour, kWhite, 0.35));
      return draw_rect(ink, box, {look.colour, 0.8});
    case Series::Style::measured: break;
  }
  if (drawn_as_marks(series)) {
    if (errors) draw_error_bar(ink, middle - Vec2{0, 7}, middle + Vec2{0, 7}, {look.colour, 1.2});
    return draw_mark(ink, middle, look);
  }
  if (errors) fill_rect(ink, {left.x, left.y - 4, right.x, left.y + 4}, mix(look.colour, kWhite, 0.3));
  draw_line(ink, left, right, {look.colour, kLine});
}

}  // namespace carom::draw
