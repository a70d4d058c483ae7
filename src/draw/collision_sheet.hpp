// The page that a collision is drawn on: what its panels have in common.
#pragma once

#include <array>
#include <string>

#include "carom/draw/collision.hpp"
#include "collision_view.hpp"
#include "ink.hpp"
#include "rect.hpp"
#include "text.hpp"

namespace carom::draw {

inline constexpr Colour kVelocityColour = kBlue;
inline constexpr Colour kNormalColour = kVermilion;
inline constexpr Colour kTangentColour = kGreen;
inline constexpr std::array<Colour, 2> kDiskColours{kSkyBlue, kOrange};

/// Of the largest speed: what is smaller is rounding, and called zero.
inline constexpr double kRounding = 1e-12;

/// Three columns of one size: a title above all, a panel each, lines of numbers below.
struct Sheet {
  const CollisionPicture& collision;
  CollisionView view;
  double scale = 1;         ///< pixels per unit of the view
  double panel_height = 0;  ///< pixels

  [[nodiscard]] double width() const noexcept;
  [[nodiscard]] double height() const noexcept;
  /// Where the panel of column 0, 1 or 2 is.
  [[nodiscard]] Rect panel(int column) const noexcept;
};

/// Keeps a reference to the collision.
Sheet sheet_of(const CollisionPicture& collision);

/// **v** with subscript: disk 1 or 2 (here 0 or 1) and what kind of part, "n", "t", "f" (after) or none.
RichText vector_name(int disk, const std::string& kind);
/// *v* with the same subscripts: the signed size of a part.
RichText size_name(int disk, const std::string& kind);

/// Disks, lines and arrows of all three panels.
void draw_panels(cairo_t* ink, const Sheet& sheet);

/// The lines below the panels.
void draw_numbers(cairo_t* ink, const Sheet& sheet);

}  // namespace carom::draw
