// A derivation as data: steps of sentences and chains of equations. The three formats are written from it.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "expression.hpp"

namespace carom::explaining {

enum class Relation { equal, about, greater, less };

/// One member of a chain, and how it stands to the member before it.
struct Member {
  Relation relation = Relation::equal;
  Expr expression;
};

/// a = b = c ≈ d, with the equation's number in the source text if it has one.
struct Chain {
  std::string tag;
  std::vector<Member> members;
};

/// A piece of a sentence: words, mathematics, or computer type.
struct Words {
  std::string text;
};
struct Code {
  std::string text;
};
struct Run {
  std::variant<Words, Code, Chain> content;

  Run(const char* words) : content(Words{words}) {}                               // NOLINT: sentences read as written
  Run(std::string words) : content(Words{std::move(words)}) {}                    // NOLINT
  Run(Code code) : content(std::move(code)) {}                                    // NOLINT
  Run(Chain chain) : content(std::move(chain)) {}                                 // NOLINT
  Run(Expr formula) : Run(Chain{"", {{Relation::equal, std::move(formula)}}}) {}  // NOLINT
};

struct Paragraph {
  std::vector<Run> runs;
};

/// Several short chains side by side behind a label.
struct Row {
  std::string label;
  std::vector<Chain> chains;
};

/// Lines in computer type.
struct Listing {
  std::vector<std::string> lines;
};

using Block = std::variant<Paragraph, Row, Chain, Listing>;

struct Step {
  std::string heading;
  std::vector<Block> blocks;
};

struct Document {
  std::string title;
  std::vector<Step> steps;
};

std::string text_of(const Document& document);
std::string markdown_of(const Document& document);
std::string latex_of(const Document& document);

}  // namespace carom::explaining
