#include "render_mathematics.hpp"

#include <fmt/format.h>

#include "notation.hpp"

namespace carom::explaining {
namespace {

constexpr int kColumns = 84;  // of text that fit on a line of a printed page

// A member that is too long for a line, cut at its breaks.
std::string cut(const Expr& formula) {
  const std::vector<std::string> lines = pieces(written(formula, Notation::latex_inline));
  const std::vector<std::string> widths = pieces(written(formula, Notation::text));
  std::string out = lines[0];
  int column = width(widths[0]);
  for (std::size_t k = 1; k < lines.size(); ++k) {
    column += 1 + width(widths[k]);
    if (column > kColumns) {
      out += " \\\\\n&\\qquad {}";
      column = width(widths[k]);
    }
    out.append(" ").append(lines[k]);
  }
  return out;
}

bool fits(const std::string& text) { return width(text) <= kColumns; }

std::string member_line(const Expr& formula) {
  if (fits(written(formula, Notation::text))) return unbroken(written(formula, Notation::latex));
  return cut(formula);
}

}  // namespace

std::string displayed(const Chain& chain) {
  if (fits(written_on_one_line(chain, Notation::text))) return written_on_one_line(chain, Notation::latex);
  const std::size_t head = head_length(chain, kColumns);
  std::string out = fmt::format("\\begin{{aligned}}\n{}", written_on_one_line(chain, 1, Notation::latex));
  for (std::size_t k = 1; k < chain.members.size(); ++k) {
    if (k >= head) out += " \\\\\n";
    out += fmt::format("{}{} {}",
                       k == 1     ? " &"
                       : k < head ? " "
                                  : "&",
                       written(chain.members[k].relation, Notation::latex), member_line(chain.members[k].expression));
  }
  return out + "\n\\end{aligned}";
}

std::string displayed(const Row& row) {
  std::string text;
  for (const Chain& chain : row.chains) text.append("  ").append(written_on_one_line(chain, Notation::text));
  const bool one_line = fits(text);
  std::string out = one_line ? "" : "\\begin{aligned}\n";
  out += fmt::format("\\text{{{}:}}", row.label);
  for (std::size_t k = 0; k < row.chains.size(); ++k) {
    out += k == 0 || one_line ? " \\quad " : " \\\\\n";
    if (!one_line) out += "& ";
    out += written_on_one_line(row.chains[k], Notation::latex);
  }
  return one_line ? out : out + "\n\\end{aligned}";
}

}  // namespace carom::explaining
