#include "collision_sheet.hpp"

#include <algorithm>

namespace carom::draw {
namespace {

constexpr double kMargin = 24;
constexpr double kPanelWidth = 372;
constexpr double kPanelGap = 12;
constexpr double kLeastPanelHeight = 240;
constexpr double kGreatestPanelHeight = 380;
constexpr double kLabelRoom = 34;      // around the sketch, for labels
constexpr double kLargestRadius = 66;  // mean of the two drawn
constexpr double kTop = 104;           // titles, down to the panels
constexpr double kNumbersHeight = 118;

const char* digit(int disk) { return disk == 0 ? "1" : "2"; }

}  // namespace

Sheet sheet_of(const CollisionPicture& collision) {
  Sheet sheet{collision, view_of(collision)};
  const Vec2 extent = sheet.view.high - sheet.view.low;
  sheet.scale = std::min(
      {kLargestRadius, (kPanelWidth - 2 * kLabelRoom) / extent.x, (kGreatestPanelHeight - 2 * kLabelRoom) / extent.y});
  sheet.panel_height = std::max(kLeastPanelHeight, sheet.scale * extent.y + 2 * kLabelRoom);
  return sheet;
}

double Sheet::width() const noexcept { return 2 * kMargin + 3 * kPanelWidth + 2 * kPanelGap; }

double Sheet::height() const noexcept { return kTop + panel_height + kNumbersHeight; }

Rect Sheet::panel(int column) const noexcept {
  const double left = kMargin + column * (kPanelWidth + kPanelGap);
  return {left, kTop, left + kPanelWidth, kTop + panel_height};
}

RichText vector_name(int disk, const std::string& kind) { return RichText{}.bold("v").sub(digit(disk) + kind); }

RichText size_name(int disk, const std::string& kind) { return RichText{}.italic("v").sub(digit(disk) + kind); }

}  // namespace carom::draw
