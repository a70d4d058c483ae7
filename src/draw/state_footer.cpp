#include "state_footer.hpp"

#include <algorithm>
#include <cmath>

#include "phase_colours.hpp"

namespace carom::draw {
namespace {

constexpr double kTextSize = 13;
constexpr double kLineHeight = 24;
constexpr double kGapAfterLead = 7;
constexpr double kGapBetween = 26;
constexpr double kSwatch = 12;
constexpr double kShadesWidth = 150;
constexpr double kWheelRadius = 34;
constexpr double kWheelWidth = 2 * kWheelRadius + 32;
constexpr double kWheelHeight = 2 * kWheelRadius + 48;
constexpr double kWidestTime = 110;       // in pictures of one film: what follows keeps its place
constexpr double kLongestScaleBar = 160;  // pixels

// The largest 1, 2 or 5 times a power of ten that is at most `most`.
double round_number_below(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= most) return digit * power;
  }
  return power;
}

void add_scale_bar(const StateView& view, double width, Footer& footer) {
  const double most = std::min({kLongestScaleBar, 0.4 * width, view.area.width()}) / view.scale;
  const double bar = round_number_below(most);
  if (!(bar > 0) || !std::isfinite(bar)) return;  // a scale beyond what doubles hold
  footer.items.push_back({FooterItem::Kind::scale_bar, RichText{}.plain("length ").number(bar), bar * view.scale});
}

void add_arrow(const StateView& view, double width, Footer& footer) {
  if (!(view.velocity > 0)) return;
  const double most = std::min(kLongestScaleBar, 0.4 * width) / view.velocity;
  const double shown = round_number_below(std::min(most, view.fastest));
  if (!(shown > 0) || !std::isfinite(shown)) return;
  footer.items.push_back({FooterItem::Kind::arrow, RichText{}.plain("speed ").number(shown), shown * view.velocity});
}

void add_facts(const System& system, const Frame& frame, Footer& footer) {
  footer.items.push_back({FooterItem::Kind::text, RichText{}.italic("t").plain(" = ").number(frame.time)});
  footer.items.push_back({FooterItem::Kind::text, RichText{}.italic("N").plain(" = " + std::to_string(frame.size()))});
  const bool open = system.box.boundary[0] == Boundary::open || system.box.boundary[1] == Boundary::open;
  const double eta = packing_fraction(system);
  if (open || !(eta > 0)) return;
  footer.items.push_back({FooterItem::Kind::text, RichText{}.italic("\u03b7").plain(" = ").number(eta)});
}

void add_meaning_of_colours(const System& system, const StateColours& colours, Footer& footer) {
  if (colours.wheel) {
    RichText text = RichText{}.plain("colour: angle of \u03c8").sub("6").plain(";  strength: |\u03c8").sub("6");
    footer.items.push_back({FooterItem::Kind::text, text.plain("|, 0 \u2026 1")});
    return;
  }
  if (!colours.quantity.empty()) {
    const RichText text =
        RichText{}.plain(colours.quantity + " ").number(colours.low).plain(" \u2026 ").number(colours.high);
    footer.items.push_back({FooterItem::Kind::shades, text, kShadesWidth});
    return;
  }
  for (std::size_t species = 0; species < system.species.size(); ++species) {
    RichText text = RichText{}.italic("r").plain(" = ").number(system.species[species].radius);
    text.plain(", ").italic("m").plain(" = ").number(system.species[species].mass);
    footer.items.push_back({FooterItem::Kind::swatch, text, kSwatch, colours.classes[species]});
  }
}

void lay_out(cairo_t* ink, double width, Footer& footer) {
  if (footer.wheel) width -= kWheelWidth + kGapBetween;
  double x = 0, y = kLineHeight;
  for (FooterItem& item : footer.items) {
    const double lead = item.lead > 0 ? item.lead + kGapAfterLead : 0;
    const double size = lead + std::max(item.least_width, measure(ink, item.text, kTextSize).x);
    if (x > 0 && x + size > width) {
      x = 0;
      y += kLineHeight;
    }
    item.place = {x, y};
    x += size + kGapBetween;
  }
  footer.height = std::max(y + 0.5 * kLineHeight, footer.wheel ? kWheelHeight : 0);
}

// The angles are written around it.
void draw_wheel(cairo_t* ink, Vec2 centre) {
  constexpr double kSize = 11;
  draw_phase_wheel(ink, centre, kWheelRadius);
  const double middle = 0.36 * kSize, gap = kWheelRadius + 5;
  draw_text(ink, RichText{}.plain("0"), centre + Vec2{gap, middle}, kSize, kBlack);
  draw_text(ink, RichText{}.plain("\u03c0"), centre + Vec2{-gap, middle}, kSize, kBlack, Align::right);
  draw_text(ink, RichText{}.plain("\u03c0/2"), centre + Vec2{0, -gap + 1}, kSize, kBlack, Align::centre);
  draw_text(ink, RichText{}.plain("\u2212\u03c0/2"), centre + Vec2{0, gap + 0.74 * kSize - 1}, kSize, kBlack,
            Align::centre);
}

void draw_scale_bar(cairo_t* ink, Vec2 at, double width) {
  const double y = at.y - 0.36 * kTextSize;
  const Pen pen{kBlack, 1.6};
  draw_line(ink, {at.x, y}, {at.x + width, y}, pen);
  draw_line(ink, {at.x, y - 4}, {at.x, y + 4}, pen);
  draw_line(ink, {at.x + width, y - 4}, {at.x + width, y + 4}, pen);
}

void draw_sample_arrow(cairo_t* ink, Vec2 at, double width) {
  const double y = at.y - 0.36 * kTextSize;
  draw_arrow(ink, {at.x, y}, {at.x + width, y}, {kBlack, 1.6});
}

void draw_shades(cairo_t* ink, Vec2 at, const std::vector<Colour>& shades) {
  const double step = kShadesWidth / static_cast<double>(shades.size());
  for (std::size_t shade = 0; shade < shades.size(); ++shade) {
    const double left = at.x + step * static_cast<double>(shade);
    // Each shade runs on below the next, so that no white shows between them.
    fill_rect(ink, {left, at.y - 11, at.x + kShadesWidth, at.y + 1}, shades[shade]);
  }
}

}  // namespace

Footer footer_of(cairo_t* ink, const System& system, const Frame& frame, const StatePicture& picture,
                 const StateView& view, const StateColours& colours, double width) {
  Footer footer;
  footer.wheel = colours.wheel;
  add_facts(system, frame, footer);
  if (picture.shared) footer.items.front().least_width = kWidestTime;
  add_scale_bar(view, width, footer);
  add_arrow(view, width, footer);
  add_meaning_of_colours(system, colours, footer);
  lay_out(ink, width, footer);
  return footer;
}

void draw_footer(cairo_t* ink, const Footer& footer, Vec2 top_left, double width, const StateColours& colours) {
  if (footer.wheel) {
    draw_wheel(ink, top_left + Vec2{width - 0.5 * kWheelWidth, 0.5 * kWheelHeight});
  }
  for (const FooterItem& item : footer.items) {
    const Vec2 at = top_left + item.place;
    const double lead = item.lead > 0 ? item.lead + kGapAfterLead : 0;
    switch (item.kind) {
      case FooterItem::Kind::text: break;
      case FooterItem::Kind::scale_bar: draw_scale_bar(ink, at, item.lead); break;
      case FooterItem::Kind::arrow: draw_sample_arrow(ink, at, item.lead); break;
      case FooterItem::Kind::shades: draw_shades(ink, at, colours.classes); break;
      case FooterItem::Kind::swatch:
        fill_circle(ink, {at.x + 0.5 * kSwatch, at.y - 0.36 * kTextSize}, 0.5 * kSwatch, item.colour);
        break;
    }
    draw_text(ink, item.text, {at.x + lead, at.y}, kTextSize, kBlack);
  }
}

}  // namespace carom::draw
