// The derivation for an 80-column terminal.
#include <fmt/format.h>

#include <algorithm>

#include "document.hpp"
#include "notation.hpp"

namespace carom::explaining {
namespace {

constexpr int kColumns = 80;
constexpr int kIndent = 4;  // of mathematics; "(5) " fills it

std::string spaces(int count) { return fmt::format("{:{}}", "", count); }

// Appends `pieces` to `line`, beginning a new line (indented by `indent`) where the next one does not fit.
void append_wrapped(std::string& out, std::string line, const std::vector<std::string>& pieces, int indent) {
  bool first = true;
  for (const std::string& piece : pieces) {
    const int glue = first ? 0 : 1;
    if (!first && width(line) + glue + width(piece) > kColumns) {
      out += line + "\n";
      line = spaces(indent) + piece;
    } else {
      line += spaces(glue) + piece;
    }
    first = false;
  }
  out += line + "\n";
}

void append(std::string& out, const Chain& chain) {
  const std::string margin = chain.tag.empty() ? spaces(kIndent) : fmt::format("({}) ", chain.tag);
  const std::string one_line = margin + written_on_one_line(chain, Notation::text);
  if (width(one_line) <= kColumns) {
    out += one_line + "\n";
    return;
  }
  const int align = width(margin) + width(written_on_one_line(chain, 1, Notation::text)) + 1;
  const std::size_t head = head_length(chain, kColumns - kIndent);
  std::string line = margin + written_on_one_line(chain, head - 1, Notation::text) + " ";
  for (std::size_t k = head - 1; k < chain.members.size(); ++k) {
    const Member& member = chain.members[k];
    append_wrapped(out, line + written(member.relation, Notation::text) + " ",
                   pieces(written(member.expression, Notation::text)), align + 4);
    line = spaces(align);
  }
}

std::string in_line(const Run& run) {
  if (const auto* words = std::get_if<Words>(&run.content)) return words->text;
  if (const auto* code = std::get_if<Code>(&run.content)) return code->text;
  return written_on_one_line(std::get<Chain>(run.content), Notation::text);
}

// Sentences wrap between words, but not inside mathematics.
void append(std::string& out, const Paragraph& paragraph) {
  std::string line;
  for (const Run& run : paragraph.runs) {
    std::string piece = in_line(run);
    if (std::holds_alternative<Words>(run.content))
      for (char& c : piece) c = c == ' ' ? kBreak : c;
    line += piece;
  }
  append_wrapped(out, "", pieces(line), 0);
}

void append(std::string& out, const Row& row) {
  const std::string label = spaces(kIndent) + row.label + ":";
  std::vector<std::string> cells;
  int longest = 0;
  for (const Chain& chain : row.chains) {
    cells.push_back(spaces(2) + written_on_one_line(chain, Notation::text));
    longest = std::max(longest, width(cells.back()));
  }
  const int aligned = width(label) + 1;
  append_wrapped(out, label + " ", cells, aligned + longest <= kColumns ? aligned : kIndent + 2);
}

void append(std::string& out, const Listing& listing) {
  for (const std::string& line : listing.lines) out += spaces(kIndent) + line + "\n";
}

// Chains and rows stand close together, everything else is set off by an empty line.
bool joins(const Block& above, const Block& below) {
  const bool mathematics = std::holds_alternative<Chain>(above) && std::holds_alternative<Chain>(below);
  return mathematics || (std::holds_alternative<Row>(above) && std::holds_alternative<Row>(below));
}

}  // namespace

std::string text_of(const Document& document) {
  std::string out = document.title + "\n" + std::string(document.title.size(), '=') + "\n";
  int number = 0;
  for (const Step& step : document.steps) {
    out += fmt::format("\n{}. {}\n", ++number, step.heading);
    const Block* above = nullptr;
    for (const Block& block : step.blocks) {
      if (above == nullptr || !joins(*above, block)) out += "\n";
      std::visit([&](const auto& content) { append(out, content); }, block);
      above = &block;
    }
  }
  return out;
}

}  // namespace carom::explaining
