#include "redo.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace redo {
namespace {

using Values = std::map<std::string, Value>;

struct UnknownSymbol : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Bounds of a number, and the sum of the sizes of what it was added up from.
struct Range {
  Number low, high, scale;
};
using Ranges = std::vector<Range>;

Range operator+(const Range& a, const Range& b) { return {a.low + b.low, a.high + b.high, a.scale + b.scale}; }
Range operator-(const Range& a) { return {-a.high, -a.low, a.scale}; }
Range operator*(const Range& a, const Range& b) {
  const Number p[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  return {*std::min_element(p, p + 4), *std::max_element(p, p + 4), a.scale * b.scale};
}
Range inverse(const Range& a) {
  const Number p[] = {1 / a.low, 1 / a.high};
  return {*std::min_element(p, p + 2), *std::max_element(p, p + 2),
          1 / std::min(Number(abs(a.low)), Number(abs(a.high)))};
}
Range root(const Range& a) { return {sqrt(a.low), sqrt(a.high), sqrt(a.scale)}; }

// Evaluates one member; every number in it may be off by `slack` of its size.
class Calculator {
 public:
  Calculator(std::string text, const Values& values, const Number& slack)
      : text_(std::move(text)), values_(values), slack_(slack) {}

  Ranges run() {
    const Ranges result = sum();
    if (at_ != text_.size()) throw std::runtime_error("cannot read '" + text_.substr(at_) + "'");
    return result;
  }

 private:
  bool next(const std::string& token) {
    std::size_t start = at_;
    while (start < text_.size() && text_[start] == ' ') ++start;
    if (text_.compare(start, token.size(), token) != 0) return false;
    at_ = start + token.size();
    return true;
  }
  void expect(const std::string& token) {
    if (!next(token)) throw std::runtime_error("no '" + token + "' before '" + text_.substr(at_) + "'");
  }

  static Ranges negative(Ranges a) {
    for (Range& part : a) part = -part;
    return a;
  }
  static Ranges plus(Ranges a, const Ranges& b) {
    if (a.size() != b.size()) throw std::runtime_error("vector plus number");
    for (std::size_t k = 0; k < a.size(); ++k) a[k] = a[k] + b[k];
    return a;
  }
  static Ranges times(const Ranges& a, const Ranges& b) {
    if (a.size() == 2 && b.size() == 2) return {a[0] * b[0] + a[1] * b[1]};
    if (a.size() == 2) return {a[0] * b[0], a[1] * b[0]};
    Ranges result = b;
    for (Range& part : result) part = a[0] * part;
    return result;
  }

  Ranges sum() {
    Ranges total = next("-") ? negative(product()) : product();
    for (;;) {
      if (next("+ ")) {
        if (text_[at_] == '-') throw std::runtime_error("a minus sign after a plus sign");
        total = plus(total, product());
      } else if (next("- ")) {
        if (text_[at_] == '-') throw std::runtime_error("a minus sign after a minus sign");
        total = plus(total, negative(product()));
      } else {
        return total;
      }
    }
  }

  Ranges product() {
    Ranges result = power();
    for (;;) {
      if (next("·")) {
        result = times(result, power());
      } else if (next("/")) {
        result = times({inverse(power().at(0))}, result);
      } else {
        return result;
      }
    }
  }

  Ranges power() {
    Ranges base = primary();
    if (!next("²")) return base;
    const Range& a = base.at(0);
    Range square = a * a;
    if (a.low < 0 && a.high > 0) square.low = 0;
    return {square};
  }

  Ranges primary() {
    if (next("√")) return {root(primary().at(0))};
    if (next("⟨")) return pair("⟩");
    if (next("-(")) return negative(in_parentheses());
    if (next("(")) return in_parentheses();
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_]))) return {number()};
    return name();
  }

  Ranges in_parentheses() {
    Ranges first = sum();
    if (next(",")) {
      first.push_back(sum().at(0));
    }
    expect(")");
    return first;
  }
  Ranges pair(const std::string& close) {
    Ranges result = sum();
    expect(",");
    result.push_back(sum().at(0));
    expect(close);
    return result;
  }

  Range number() {
    static const std::regex kNumber("^[0-9]+(\\.[0-9]+)?(e-?[0-9]+)?");
    std::smatch match;
    const std::string rest = text_.substr(at_);
    if (!std::regex_search(rest, match, kNumber)) throw std::runtime_error("no number: " + rest);
    at_ += match[0].length();
    if (match[1].matched && match[1].str().back() == '0') throw std::runtime_error("trailing zero: " + match[0].str());
    const Number value(match[0].str());
    return {value * (1 - slack_), value * (1 + slack_), value};
  }

  Ranges name() {
    std::size_t end = at_;
    while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) || text_[end] == '_' ||
                                  text_[end] == '|' || text_.compare(end, 2, "Δ") == 0))
      end += text_.compare(end, 2, "Δ") == 0 ? 2 : 1;
    const std::string symbol = text_.substr(at_, end - at_);
    if (symbol.empty()) throw std::runtime_error("no name: " + text_.substr(at_));
    at_ = end;
    const auto known = values_.find(symbol);
    if (known == values_.end()) throw UnknownSymbol(symbol);
    Ranges result;
    for (const Number& part : known->second) result.push_back({part, part, abs(part)});
    return result;
  }

  std::string text_;
  const Values& values_;
  Number slack_;
  std::size_t at_ = 0;
};

struct Line {
  std::string text;
  std::string tag;
};

struct Member {
  std::string relation;
  std::string text;
};

std::vector<Member> members_of(const std::string& line) {
  static const std::vector<std::string> kRelations{" = ", " ≈ ", " > ", " < "};
  std::vector<Member> members{{"", ""}};
  for (std::size_t k = 0; k < line.size();) {
    const auto relation = std::find_if(kRelations.begin(), kRelations.end(), [&](const std::string& sign) {
      return line.compare(k, sign.size(), sign) == 0;
    });
    if (relation == kRelations.end()) {
      members.back().text += line[k++];
    } else {
      members.push_back({relation->substr(1, relation->size() - 2), ""});
      k += relation->size();
    }
  }
  return members;
}

bool contains_zero(const std::string& member) {
  static const std::regex kZero("(^|[^0-9.])0($|[^0-9.])");
  return std::regex_search(member, kZero);
}

bool has_no_symbol(const std::string& member) {
  static const std::regex kSymbol("[A-DF-Za-df-z|_]|Δ");
  return !std::regex_search(member, kSymbol) && !std::regex_match(member, std::regex("e"));
}

class Student {
 public:
  Report redo(const std::string& text) {
    read_restitution(text);
    for (const Line& line : lines_of(text)) {
      if (!line.tag.empty()) report_.tags.push_back(line.tag);
      try {
        redo_line(line.text);
      } catch (const std::exception& problem) {
        mistake(line.text, problem.what());
      }
    }
    return std::move(report_);
  }

 private:
  void mistake(const std::string& line, const std::string& reason) { report_.mistakes.push_back(reason + ": " + line); }

  void read_restitution(const std::string& text) {
    std::smatch match;
    if (std::regex_search(text, match, std::regex("[( ]e\\s=\\s([0-9.e-]*[0-9])")))
      report_.values["e"] = {Number(match[1].str())};
  }

  // Lines of mathematics start with four blanks or a tag; what starts farther right goes on with the line above.
  static std::vector<Line> lines_of(const std::string& text) {
    static const std::regex kTagged("^\\(([0-9A-D])\\) (.*)");
    std::vector<Line> lines;
    std::istringstream in(text);
    std::smatch match;
    for (std::string line; std::getline(in, line);) {
      if (std::regex_match(line, match, kTagged)) {
        lines.push_back({match[2], match[1]});
      } else if (line.rfind("     ", 0) == 0 && !lines.empty()) {
        const bool next_cell = lines.back().text.rfind("Disk", 0) == 0;
        lines.back().text += (next_cell ? "   " : " ") + line.substr(line.find_first_not_of(' '));
      } else if (line.rfind("    ", 0) == 0 && line.find("velocity") == std::string::npos) {
        lines.push_back({line.substr(4), ""});
      }
    }
    return lines;
  }

  void redo_line(const std::string& line) {
    if (line.rfind("Disk", 0) != 0) return redo_chain(line);
    std::string cells = line.substr(line.find("   "));
    for (std::size_t k; (k = cells.find_first_not_of(' ')) != std::string::npos;) {
      cells = cells.substr(k);
      const std::size_t end = std::min(cells.find("   "), cells.size());
      redo_chain(cells.substr(0, end));
      cells = cells.substr(end);
    }
  }

  std::optional<Ranges> evaluated(const std::string& member, const Number& slack = 0) {
    try {
      return Calculator(member, report_.values, slack).run();
    } catch (const UnknownSymbol&) {
      return std::nullopt;
    }
  }

  // The first member only names what follows, unless it is a formula.
  static bool is_name(const std::string& member) {
    return !has_no_symbol(member) && member.find_first_of("+/") == std::string::npos &&
           member.find("·") == std::string::npos && member.find(" - ") == std::string::npos;
  }

  void redo_chain(const std::string& line) {
    const std::vector<Member> members = members_of(line);
    std::optional<Ranges> above;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Member& member = members[k];
      const bool named_anew = is_name(member.text) && (k == 0 || member.text.rfind("⟨v", 0) == 0);
      const std::optional<Ranges> now = named_anew && k + 1 < members.size() ? std::nullopt : evaluated(member.text);
      if (above && now) check(line, *above, member, *now);
      if (now) above = now;
    }
    const std::string& last = members.back().text;
    const std::string& result =
        members.back().relation == ">" || members.back().relation == "<" ? members[members.size() - 2].text : last;
    if (has_no_symbol(result))
      for (const Member& member : members)
        if (is_name(member.text)) define(member.text, result);
  }

  void define(const std::string& names, const std::string& result) {
    Value value;
    const Ranges parts = evaluated(result).value();
    for (const Range& part : parts) value.push_back(part.low);
    static const std::regex kPair("^(?:⟨|\\()(.*), (.*)(?:⟩|\\))$");
    std::smatch match;
    if (std::regex_match(names, match, kPair)) {
      report_.values[match[1]] = {value.at(0)};
      report_.values[match[2]] = {value.at(1)};
    } else {
      report_.values[names] = value;
    }
  }

  void check(const std::string& line, const Ranges& above, const Member& member, const Ranges& now) {
    ++report_.relations;
    if (above.size() != now.size()) return mistake(line, "a vector and a number");
    bool equal = true;
    for (std::size_t k = 0; k < now.size(); ++k) {
      const Number difference = abs(above[k].low - now[k].low);
      equal = equal && difference <= Number("1e-80") * (above[k].scale + now[k].scale);
    }
    if (member.relation == "=" && !equal) mistake(line, "not equal: " + member.text);
    if (member.relation == "≈" && equal) mistake(line, "equal, not only about equal: " + member.text);
    if (member.relation == "≈") check_about(line, above, member);
    if (member.relation == ">" && !(above[0].low > now[0].low)) mistake(line, "not greater");
    if (member.relation == "<" && !(above[0].low < now[0].low)) mistake(line, "not less");
  }

  void check_about(const std::string& line, const Ranges& above, const Member& member) {
    const Ranges near = *evaluated(member.text, Number("5.00000001e-8"));
    for (std::size_t k = 0; k < near.size(); ++k) {
      // A sum of rounded numbers that cancels below its eighth digit is shown as 0.
      const Number cancelled = contains_zero(member.text) ? Number(above[k].scale * Number("1e-7")) : Number(0);
      if (above[k].low < near[k].low - cancelled || above[k].low > near[k].high + cancelled)
        mistake(line, "not even about equal: " + member.text);
    }
  }

  Report report_;
};

}  // namespace

Report redo(const std::string& text) { return Student().redo(text); }

}  // namespace redo
