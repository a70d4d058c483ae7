// Numbers against numbers as a picture: curves, points with error bars, histograms, theory.
#pragma once

#include <string>
#include <vector>

#include "carom/draw/format.hpp"
#include "carom/run/measurement.hpp"

namespace carom {

/// Points that belong together and are drawn alike. Where x or y is not finite (or not positive on a logarithmic axis)
/// there is a gap.
struct Series {
  enum class Style {
    measured,  ///< up to 60 points: marks with error bars; more: a line in a band of one standard error
    bars,      ///< a histogram: y is drawn from 0 up, between the middles of neighbouring x
    theory     ///< a dashed line
  };
  Style style = Style::measured;
  std::string label;               ///< in the legend
  std::vector<double> x, y;        ///< of equal length
  std::vector<double> error = {};  ///< one standard error of each y; empty, or as long; NaN where it is not known
};

struct PlotAxis {
  std::string label;  ///< with its unit
  bool logarithmic = false;
};

/// One frame of axes.
struct PlotPanel {
  PlotAxis y;
  std::vector<Series> series;
};

/// Panels one above the other that share the x axis.
struct Plot {
  std::string title;
  PlotAxis x;
  std::vector<PlotPanel> panels;
};

/// The picture's bytes, to be written to a file; 127 mm wide where print has a size. The same plot gives the same
/// bytes. Texts may hold any bytes: what is not printable UTF-8 shows as a question mark. Axes without a single number
/// to show say so. Throws Error if there is no panel, or x, y and error of a series differ in length.
std::string picture_of_plot(const Plot& plot, PictureFormat format);

/// A table as a plot: its first column along x; every other column a curve, those of one unit and a like size in one
/// panel, with its errors from NAME_error and what theory says from NAME_theory. Columns without rows, or no columns at
/// all, give empty axes.
Plot plot_of_table(const Table& table);

}  // namespace carom
