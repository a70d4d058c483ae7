// The derivation in Markdown with $$ mathematics, as GitHub and most notebooks show it.
#include <fmt/format.h>

#include "document.hpp"
#include "notation.hpp"
#include "render_mathematics.hpp"

namespace carom::explaining {
namespace {

std::string tag_of(const std::string& tag) { return tag.empty() ? "" : fmt::format(" \\tag{{{}}}", tag); }

std::string display(const std::string& body) { return fmt::format("$$\n{}\n$$\n", body); }

std::string block(const Chain& chain) { return display(displayed(chain) + tag_of(chain.tag)); }

std::string block(const Row& row) { return display(displayed(row)); }

std::string block(const Listing& listing) {
  std::string out = "```text\n";
  for (const std::string& line : listing.lines) out += line + "\n";
  return out + "```\n";
}

std::string block(const Paragraph& paragraph) {
  std::string out;
  for (const Run& run : paragraph.runs) {
    if (const auto* words = std::get_if<Words>(&run.content)) {
      out += words->text;
    } else if (const auto* code = std::get_if<Code>(&run.content)) {
      out += fmt::format("`{}`", code->text);
    } else {
      out += fmt::format("${}$", written_on_one_line(std::get<Chain>(run.content), Notation::latex_inline));
    }
  }
  return out + "\n";
}

}  // namespace

std::string markdown_of(const Document& document) {
  std::string out = fmt::format("# {}\n", document.title);
  int number = 0;
  for (const Step& step : document.steps) {
    out += fmt::format("\n## {}. {}\n", ++number, step.heading);
    for (const Block& content : step.blocks)
      out.append("\n").append(std::visit([](const auto& of_any_kind) { return block(of_any_kind); }, content));
  }
  return out;
}

}  // namespace carom::explaining
