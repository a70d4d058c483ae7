// How formulas are written: in plain text and in LaTeX.
#pragma once

#include <string>
#include <vector>

#include "document.hpp"

namespace carom::explaining {

enum class Notation {
  text,         ///< un_x·v1x + √(a² + b²)/2
  latex,        ///< fractions stand one above the other
  latex_inline  ///< fractions are written with a slash, so that lines can break in them
};

/// Stands for a space at which a long line may be broken.
inline constexpr char kBreak = '\x1f';

/// The formula, with kBreak before the summands of sums and between the components of vectors.
std::string written(const Expr& formula, Notation notation);

/// "=", "≈", ">", "<" or the LaTeX for it.
std::string written(Relation relation, Notation notation);

/// The whole chain on one line, without its tag; or its first `count` members.
std::string written_on_one_line(const Chain& chain, Notation notation);
std::string written_on_one_line(const Chain& chain, std::size_t count, Notation notation);

/// How many members stand on the first line of a chain that is too long for one: the name and the next one, and
/// those that follow without numbers as far as they fit into `columns` of text.
std::size_t head_length(const Chain& chain, int columns);

/// `line` with a space for every kBreak.
std::string unbroken(std::string line);

/// `line` cut at its kBreaks.
std::vector<std::string> pieces(const std::string& line);

/// Number of characters (not bytes).
int width(const std::string& utf8);

}  // namespace carom::explaining
