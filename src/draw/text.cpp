#include "text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/state/system.hpp"

namespace carom::draw {
namespace {

constexpr double kScriptSize = 0.72;     // of the base size
constexpr double kScriptDrop = 0.22;     // of the base size
constexpr double kScriptLift = 0.36;     // of the base size
constexpr double kCapitalHeight = 0.74;  // above the baseline, of the size
constexpr double kBoxHeight = 0.96;      // from the capitals' top to a subscript's foot

const std::string kMinus = "\u2212";

std::string with_true_minus(const std::string& digits) {
  return !digits.empty() && digits.front() == '-' ? kMinus + digits.substr(1) : digits;
}

double size_of(const RichText::Piece& piece, double size) {
  return piece.level == RichText::Level::base ? size : kScriptSize * size;
}

double rise_of(const RichText::Piece& piece, double size) {
  if (piece.level == RichText::Level::subscript) return kScriptDrop * size;
  return piece.level == RichText::Level::superscript ? -kScriptLift * size : 0;
}

void choose_font(cairo_t* ink, const RichText::Piece& piece, double size) {
  const bool italic = piece.face == RichText::Face::italic;
  const bool bold = piece.face == RichText::Face::bold;
  cairo_select_font_face(ink, "DejaVu Sans", italic ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(ink, size_of(piece, size));
}

double advance(cairo_t* ink, const RichText::Piece& piece, double size) {
  choose_font(ink, piece, size);
  cairo_text_extents_t extents;
  cairo_text_extents(ink, piece.text.c_str(), &extents);
  return extents.x_advance;
}

// Bytes of the UTF-8 character at the start; 0 if there is none, or it cannot be printed.
std::size_t size_of_character(std::string_view text) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  if (byte(0) < 0x80) return byte(0) < 0x20 || byte(0) == 0x7f ? 0 : 1;
  const std::size_t size = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < size) return 0;
  char32_t code = byte(0) & (0xffu >> (size + 1));
  for (std::size_t at = 1; at < size; ++at) {
    if ((byte(at) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(at) & 0x3fu);
  }
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0xa0, 0x800, 0x10000};  // by size: longer forms are not UTF-8
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return code < kLeast[size] || surrogate || code > 0x10ffff ? 0 : size;
}

}  // namespace

RichText& RichText::add(std::string text, Face face, Level level) {
  pieces_.push_back({std::move(text), face, level});
  return *this;
}

RichText& RichText::number(double value) {
  if (std::isinf(value)) return plain(value < 0 ? kMinus + "\u221e" : "\u221e");
  const std::string digits = fmt::format("{:.5g}", value == 0 ? 0.0 : value);
  const std::size_t exponent = digits.find('e');
  if (exponent == std::string::npos) return plain(with_true_minus(digits));
  plain(with_true_minus(digits.substr(0, exponent)) + "\u00d710");
  const std::string power = fmt::format("{}", std::stoi(digits.substr(exponent + 1)));
  return add(with_true_minus(power), Face::plain, Level::superscript);
}

RichText& RichText::vector(Vec2 value) {
  return plain("\u27e8").number(value.x).plain(", ").number(value.y).plain("\u27e9");
}

RichText& RichText::append(const RichText& other) {
  pieces_.insert(pieces_.end(), other.pieces_.begin(), other.pieces_.end());
  return *this;
}

Vec2 measure(cairo_t* ink, const RichText& text, double size) {
  double width = 0;
  for (const RichText::Piece& piece : text.pieces()) width += advance(ink, piece, size);
  return {width, kBoxHeight * size};
}

void draw_text(cairo_t* ink, const RichText& text, Vec2 at, double size, Colour colour, Align align) {
  const double width = align == Align::left ? 0 : measure(ink, text, size).x;
  double x = align == Align::left ? at.x : align == Align::right ? at.x - width : at.x - 0.5 * width;
  set_colour(ink, colour);
  for (const RichText::Piece& piece : text.pieces()) {
    const double step = advance(ink, piece, size);
    cairo_move_to(ink, x, at.y + rise_of(piece, size));
    cairo_show_text(ink, piece.text.c_str());
    x += step;
  }
  cairo_new_path(ink);
}

void draw_text_upwards(cairo_t* ink, const RichText& text, Vec2 at, double size, Colour colour) {
  cairo_save(ink);
  cairo_translate(ink, at.x, at.y);
  cairo_rotate(ink, -0.5 * kPi);
  draw_text(ink, text, {0, 0}, size, colour, Align::centre);
  cairo_restore(ink);
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t size = size_of_character(text);
    shown += size == 0 ? std::string_view("?") : text.substr(0, size);
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return shown;
}

void draw_text_around(cairo_t* ink, const RichText& text, Vec2 centre, double size, Colour colour) {
  const double baseline = centre.y + (kCapitalHeight - 0.5 * kBoxHeight) * size;
  draw_text(ink, text, {centre.x, baseline}, size, colour, Align::centre);
}

}  // namespace carom::draw
