// The derivation as a LaTeX document that compiles as it stands.
#include <fmt/format.h>

#include "document.hpp"
#include "notation.hpp"
#include "render_mathematics.hpp"

namespace carom::explaining {
namespace {

constexpr const char* kBeginning = R"(\documentclass{article}
\usepackage[utf8]{inputenc}
\usepackage[margin=2cm]{geometry}
\usepackage{amsmath}
\setlength{\parindent}{0pt}
\setlength{\parskip}{1ex}
\begin{document}
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '_' || c == '%' || c == '&' || c == '#' || c == '$') out += '\\';
    out += c;
  }
  return out;
}

std::string equation(const std::string& body) {
  return fmt::format("\\begin{{equation*}}\n{}\n\\end{{equation*}}\n", body);
}

std::string block(const Chain& chain) {
  const std::string tag = chain.tag.empty() ? "" : fmt::format(" \\tag{{{}}}", chain.tag);
  return equation(displayed(chain) + tag);
}

std::string block(const Row& row) { return equation(displayed(row)); }

std::string block(const Listing& listing) {
  std::string out = "\\begin{verbatim}\n";
  for (const std::string& line : listing.lines) out += line + "\n";
  return out + "\\end{verbatim}\n";
}

std::string block(const Paragraph& paragraph) {
  std::string out;
  for (const Run& run : paragraph.runs) {
    if (const auto* words = std::get_if<Words>(&run.content)) {
      out += escaped(words->text);
    } else if (const auto* code = std::get_if<Code>(&run.content)) {
      out += fmt::format("\\texttt{{{}}}", escaped(code->text));
    } else {
      out += fmt::format("${}$", written_on_one_line(std::get<Chain>(run.content), Notation::latex_inline));
    }
  }
  return out + "\n";
}

}  // namespace

std::string latex_of(const Document& document) {
  std::string out = kBeginning;
  out += fmt::format("\\section*{{{}}}\n", document.title);
  int number = 0;
  for (const Step& step : document.steps) {
    out += fmt::format("\n\\subsection*{{{}. {}}}\n", ++number, step.heading);
    for (const Block& content : step.blocks)
      out.append("\n").append(std::visit([](const auto& of_any_kind) { return block(of_any_kind); }, content));
  }
  return out + "\n\\end{document}\n";
}

}  // namespace carom::explaining
