#include "carom/draw/plot.hpp"

#include <algorithm>
#include <cmath>

#include "canvas.hpp"
#include "carom/base/error.hpp"
#include "plot_scale.hpp"
#include "plot_series.hpp"

namespace carom {
namespace {

using namespace draw;

constexpr double kWidth = 480;          // pixels: 127 mm in print
constexpr double kPngScale = 4;         // dots per pixel: 384 per inch at that size
constexpr double kAloneHeight = 290;    // of the one panel
constexpr double kStackedHeight = 200;  // of each of several
constexpr double kMargin = 12;
constexpr double kRight = 18;  // room for half of the last label
constexpr double kTextSize = 13;
constexpr double kTickSize = 12;
constexpr double kTitleSize = 14;
constexpr double kTitleHeight = 26;
constexpr double kLegendLine = 20;
constexpr double kTick = 5;             // pixels, inwards
constexpr double kMinorTick = 3;        // pixels, inwards
constexpr double kBelow = 44;           // tick labels and the axis's own
constexpr double kGapAbove = 12;        // between a panel and what stands above it
constexpr double kGapForExponent = 24;  // where a power of ten stands there, too
constexpr double kPadding = 0.05;       // of what is shown
constexpr int kMostLabelsAcross = 7;
constexpr int kMostLabelsUp = 6;

// A panel laid out: its axes, legend and place.
struct LaidOut {
  const PlotPanel* panel = nullptr;
  AxisScale y;
  bool empty = false;             // nothing in it has a place
  std::vector<Vec2> legend = {};  // left ends of the samples, from the legend's top left; empty: none
  double legend_height = 0;
  double gap = kGapAbove;  // between it and the panel
  Rect area = {};
};

RichText text_of(const std::string& text) { return RichText{}.plain(printable(text)); }

// The size, at most `size`, in which the text is not wider than `room`.
double fitted(cairo_t* ink, const RichText& text, double size, double room) {
  const double width = measure(ink, text, size).x;
  return width > room ? size * room / width : size;
}

void validate(const Plot& plot) {
  if (plot.panels.empty()) throw Error("cannot draw the plot: it has no axes");
  for (const PlotPanel& panel : plot.panels) {
    for (const Series& series : panel.series) {
      const bool fits =
          series.x.size() == series.y.size() && (series.error.empty() || series.error.size() == series.x.size());
      if (!fits) throw Error("cannot draw the plot: '" + series.label + "' has numbers without a partner");
    }
  }
}

bool is_shown(double value, bool logarithmic) { return std::isfinite(value) && (!logarithmic || value > 0); }

// A logarithmic axis on which nothing could be shown is linear.
bool logarithmic_if_possible(const PlotAxis& axis, const std::vector<const std::vector<double>*>& values) {
  if (!axis.logarithmic) return false;
  return std::any_of(values.begin(), values.end(), [](const std::vector<double>* some) {
    return std::any_of(some->begin(), some->end(), [](double value) { return is_shown(value, true); });
  });
}

AxisScale scale_of_x(const Plot& plot) {
  std::vector<const std::vector<double>*> values;
  bool marks = false;
  for (const PlotPanel& panel : plot.panels) {
    for (const Series& series : panel.series) {
      values.push_back(&series.x);
      marks = marks || drawn_as_marks(series);
    }
  }
  const bool logarithmic = logarithmic_if_possible(plot.x, values);
  Extent extent;
  for (const PlotPanel& panel : plot.panels) {
    for (const Series& series : panel.series) {
      const bool bars = series.style == Series::Style::bars && !logarithmic;
      for (const double x : bars ? edges_of_bars(series.x) : series.x) {
        if (is_shown(x, logarithmic)) extent.include(x);
      }
    }
  }
  return {extent, logarithmic, marks ? kPadding : 0, kMostLabelsAcross};
}

// Values, then their errors as far as these do not squeeze the values together.
Extent extent_of_y(const PlotPanel& panel, const AxisScale& x, bool logarithmic) {
  Extent values;
  for (const Series& series : panel.series) {
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      if (x.has_place(series.x[k]) && is_shown(series.y[k], logarithmic)) values.include(series.y[k]);
    }
    if (series.style == Series::Style::bars && !logarithmic) values.include(0);
  }
  Extent extent = values;
  for (const Series& series : panel.series) {
    for (std::size_t k = 0; k < series.error.size(); ++k) {
      if (!x.has_place(series.x[k]) || !is_shown(series.y[k], logarithmic) || !std::isfinite(series.error[k])) continue;
      const double error = values.span() > 0 ? std::min(series.error[k], values.span()) : series.error[k];
      for (const double end : {series.y[k] - error, series.y[k] + error}) {
        if (is_shown(end, logarithmic)) extent.include(end);
      }
    }
  }
  return extent;
}

LaidOut with_scale(const PlotPanel& panel, const AxisScale& x) {
  std::vector<const std::vector<double>*> values;
  for (const Series& series : panel.series) values.push_back(&series.y);
  const bool logarithmic = logarithmic_if_possible(panel.y, values);
  const Extent extent = extent_of_y(panel, x, logarithmic);
  LaidOut laid{&panel, {extent, logarithmic, kPadding, kMostLabelsUp}};
  laid.empty = std::none_of(panel.series.begin(), panel.series.end(), [&](const Series& series) {
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      if (x.has_place(series.x[k]) && laid.y.has_place(series.y[k])) return true;
    }
    return false;
  });
  return laid;
}

// Samples and labels in lines of at most `width`; none where there is nothing to tell apart.
void lay_out_legend(cairo_t* ink, double width, LaidOut& laid) {
  const std::vector<Series>& series = laid.panel->series;
  if (series.size() < 2) return;
  Vec2 at{0, 0.5 * kLegendLine};
  for (const Series& one : series) {
    const double size = kSampleWidth + 6 + measure(ink, text_of(one.label), kTickSize).x;
    if (at.x > 0 && at.x + size > width) at = {0, at.y + kLegendLine};
    laid.legend.push_back(at);
    at.x += size + 18;
  }
  laid.legend_height = at.y + 0.5 * kLegendLine;
}

double widest_label(cairo_t* ink, const AxisScale& scale) {
  double widest = 0;
  for (const Tick& tick : scale.ticks()) widest = std::max(widest, measure(ink, tick.label, kTickSize).x);
  return widest;
}

RichText times_power_of_ten(int exponent) {
  const std::string power = (exponent < 0 ? "\u2212" : "") + std::to_string(std::abs(exponent));
  return RichText{}.plain("\u00d710").super(power);
}

// Draws ticks of one axis on two opposite sides; `at(place)` is where on the first side, `across` the way to the other.
template <typename Where>
void draw_ticks(cairo_t* ink, const AxisScale& scale, const Where& at, Vec2 inwards, double breadth) {
  for (const Tick& tick : scale.ticks()) {
    const Vec2 from = at(tick.place);
    const Vec2 step = (tick.major ? kTick : kMinorTick) * inwards;
    const Vec2 opposite = from + breadth * inwards;
    draw_line(ink, from, from + step, {kBlack, 1});
    draw_line(ink, opposite, opposite - step, {kBlack, 1});
  }
}

void draw_axis_up(cairo_t* ink, const LaidOut& laid) {
  const Rect& area = laid.area;
  const auto at = [&](double place) { return Vec2{area.left, area.bottom - place * area.height()}; };
  draw_ticks(ink, laid.y, at, {1, 0}, area.width());
  for (const Tick& tick : laid.y.ticks()) {
    const Vec2 end = at(tick.place) + Vec2{-6, 0.36 * kTickSize};
    draw_text(ink, tick.label, end, kTickSize, kBlack, Align::right);
  }
  if (laid.y.exponent() != 0) {
    draw_text(ink, times_power_of_ten(laid.y.exponent()), {area.left, area.top - 5}, kTickSize, kBlack);
  }
  const RichText label = text_of(laid.panel->y.label);
  const double size = fitted(ink, label, kTextSize, area.height() + 30);
  draw_text_upwards(ink, label, {kMargin + 0.8 * kTextSize, area.centre().y}, size, kBlack);
}

// Labels that would run into the one before them are left out.
void draw_labels_across(cairo_t* ink, const AxisScale& x, const Rect& area) {
  double free_from = 0;
  for (const Tick& tick : x.ticks()) {
    if (tick.label.pieces().empty()) continue;
    const double middle = area.left + tick.place * area.width();
    const double half = 0.5 * measure(ink, tick.label, kTickSize).x;
    if (middle - half < free_from) continue;
    draw_text(ink, tick.label, {middle, area.bottom + 17}, kTickSize, kBlack, Align::centre);
    free_from = middle + half + 6;
  }
}

void draw_panel(cairo_t* ink, const AxisScale& x, const LaidOut& laid) {
  const std::vector<Series>& series = laid.panel->series;
  const std::vector<Look> looks = looks_of(series);
  const PanelView view{laid.area, x, laid.y};
  draw_series(ink, view, series, looks);
  draw_rect(ink, laid.area, {kBlack, 1});
  const auto at = [&](double place) { return Vec2{laid.area.left + place * laid.area.width(), laid.area.bottom}; };
  draw_ticks(ink, x, at, {0, -1}, laid.area.height());
  draw_axis_up(ink, laid);
  if (laid.empty) {
    draw_text(ink, RichText{}.plain("no values"), laid.area.centre(), kTextSize, kGrey, Align::centre);
  }
  const Vec2 top_left{laid.area.left, laid.area.top - laid.gap - laid.legend_height};
  for (std::size_t k = 0; k < laid.legend.size(); ++k) {
    const Vec2 left = top_left + laid.legend[k];
    draw_sample(ink, series[k], looks[k], left);
    const RichText label = text_of(series[k].label);
    const double room = laid.area.right - left.x - kSampleWidth - 6;
    draw_text(ink, label, left + Vec2{kSampleWidth + 6, 0.36 * kTickSize}, fitted(ink, label, kTickSize, room), kBlack);
  }
}

// Lays the panels out below one another; returns the height of all.
double lay_out(cairo_t* ink, const Plot& plot, const AxisScale& x, std::vector<LaidOut>& panels) {
  double left = 0;
  for (const PlotPanel& panel : plot.panels) {
    panels.push_back(with_scale(panel, x));
    left = std::max(left, widest_label(ink, panels.back().y));
  }
  left += kMargin + 1.25 * kTextSize + 12;
  double y = plot.title.empty() ? 0.5 * kMargin : kTitleHeight;
  for (LaidOut& laid : panels) {
    lay_out_legend(ink, kWidth - kRight - left, laid);
    laid.gap = laid.y.exponent() != 0 ? kGapForExponent : kGapAbove;
    y += laid.legend_height + laid.gap;
    const double height = panels.size() == 1 ? kAloneHeight : kStackedHeight;
    laid.area = {left, y, kWidth - kRight, y + height};
    y += height + (panels.size() == 1 ? 0 : 8);
  }
  return panels.back().area.bottom + kBelow;
}

}  // namespace

std::string picture_of_plot(const Plot& plot, PictureFormat format) {
  validate(plot);
  const AxisScale x = scale_of_x(plot);
  std::vector<LaidOut> panels;
  const Canvas ruler(PictureFormat::png, 1, 1, 1);
  const double height = lay_out(ruler.ink(), plot, x, panels);

  Canvas canvas(format, kWidth, std::ceil(height), kPngScale);
  cairo_t* const ink = canvas.ink();
  const Rect& last = panels.back().area;
  if (!plot.title.empty()) {
    const RichText title = RichText{}.bold(printable(plot.title));
    const double size = fitted(ink, title, kTitleSize, kWidth - 2 * kMargin);
    draw_text(ink, title, {0.5 * kWidth, 0.5 * kMargin + kTitleSize}, size, kBlack, Align::centre);
  }
  for (const LaidOut& laid : panels) draw_panel(ink, x, laid);
  draw_labels_across(ink, x, last);
  if (x.exponent() != 0) {
    draw_text(ink, times_power_of_ten(x.exponent()), {last.right, last.bottom + 35}, kTickSize, kBlack, Align::right);
  }
  const RichText label = text_of(plot.x.label);
  const double room = last.width() - (x.exponent() != 0 ? 90 : 0);
  draw_text(ink, label, {last.centre().x, last.bottom + 36}, fitted(ink, label, kTextSize, room), kBlack,
            Align::centre);
  return canvas.finish();
}

}  // namespace carom
