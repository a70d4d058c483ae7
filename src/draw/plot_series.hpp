// What stands inside the axes of a plot, and the samples of it in the legend.
#pragma once

#include <cairo.h>

#include <vector>

#include "carom/draw/plot.hpp"
#include "ink.hpp"
#include "plot_scale.hpp"

namespace carom::draw {

/// A panel's axes and where they are on the canvas.
struct PanelView {
  Rect area;
  const AxisScale& x;
  const AxisScale& y;

  [[nodiscard]] bool has_place(double a, double b) const noexcept { return x.has_place(a) && y.has_place(b); }
  [[nodiscard]] Vec2 pixel(double a, double b) const noexcept {
    return {area.left + x.place(a) * area.width(), area.bottom - y.place(b) * area.height()};
  }
};

/// Where the bar of each point begins, and after the last one where it ends.
std::vector<double> edges_of_bars(const std::vector<double>& x);

/// Whether measured points are drawn as marks; else as a line in a band.
bool drawn_as_marks(const Series& series) noexcept;

/// How a series is told from the others: by colour and, in print without colours, by the shape of its marks.
struct Look {
  enum class Mark { circle, square, triangle, diamond };
  Colour colour;
  Mark mark = Mark::circle;
};

/// A look for each series: measured ones in turn; theory in black or, where several are measured, in a darker shade of
/// the one before it.
std::vector<Look> looks_of(const std::vector<Series>& series);

/// Draws the series inside the area: histograms and bands lowest, then lines, theory, and marks on top.
void draw_series(cairo_t* ink, const PanelView& view, const std::vector<Series>& series,
                 const std::vector<Look>& looks);

/// The width of samples in the legend (pixels).
inline constexpr double kSampleWidth = 26;

/// A sample of how the series is drawn, from `left` on.
void draw_sample(cairo_t* ink, const Series& series, const Look& look, Vec2 left);

}  // namespace carom::draw
