// Text with bold vectors, subscripts and powers of ten.
#pragma once

#include <cairo.h>

#include <string>
#include <string_view>
#include <vector>

#include "carom/base/vec2.hpp"
#include "ink.hpp"

namespace carom::draw {

/// A line of text made of pieces in different faces.
class RichText {
 public:
  enum class Face { plain, bold, italic };
  enum class Level { base, subscript, superscript };
  struct Piece {
    std::string text;
    Face face;
    Level level;
  };

  RichText& plain(std::string text) { return add(std::move(text), Face::plain, Level::base); }
  RichText& bold(std::string text) { return add(std::move(text), Face::bold, Level::base); }
  RichText& italic(std::string text) { return add(std::move(text), Face::italic, Level::base); }
  RichText& sub(std::string text) { return add(std::move(text), Face::plain, Level::subscript); }
  RichText& super(std::string text) { return add(std::move(text), Face::plain, Level::superscript); }
  /// A number to five significant digits, with a true minus sign, ∞, and 10ⁿ for very large and small ones.
  RichText& number(double value);
  /// ⟨x, y⟩
  RichText& vector(Vec2 value);
  RichText& append(const RichText& other);

  [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }

 private:
  RichText& add(std::string text, Face face, Level level);

  std::vector<Piece> pieces_;
};

/// Where text stands relative to the point it is drawn at.
enum class Align { left, centre, right };

/// Width and height of the text in a font of `size` pixels.
Vec2 measure(cairo_t* ink, const RichText& text, double size);

/// Draws with the baseline through `at`.
void draw_text(cairo_t* ink, const RichText& text, Vec2 at, double size, Colour colour, Align align = Align::left);

/// Draws upwards, turned to the left by a right angle, with the middle of the baseline at `at`.
void draw_text_upwards(cairo_t* ink, const RichText& text, Vec2 at, double size, Colour colour);

/// The text with a question mark in the place of every control character and every byte that is not part of UTF-8.
std::string printable(std::string_view text);

/// Draws with the middle of the measured box at `centre`.
void draw_text_around(cairo_t* ink, const RichText& text, Vec2 centre, double size, Colour colour);

}  // namespace carom::draw
