#include "carom/io/collide_batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

#include "carom/rule/batch.hpp"
#include "csv_rows.hpp"
#include "numbers.hpp"
#include "problem_list.hpp"

namespace carom {
namespace {

constexpr std::size_t kMostProblems = 20;
/// Between these the rule's squares of distances neither overflow nor vanish.
constexpr double kSmallestDistance = 1e-150;
constexpr double kLargestDistance = 1e150;

enum Quantity : std::size_t { x1, y1, vx1, vy1, m1, x2, y2, vx2, vy2, m2, kQuantities };
constexpr std::array<std::string_view, kQuantities> kNames{"x1", "y1", "vx1", "vy1", "m1",
                                                           "x2", "y2", "vx2", "vy2", "m2"};
constexpr std::array<std::string_view, 4> kAppended{"vx1_after", "vy1_after", "vx2_after", "vy2_after"};

class CollisionTable {
 public:
  CollisionTable(std::string_view csv, const std::string& name)
      : rows_(csv, name),
        line_end_(csv.find("\r\n") == std::string_view::npos ? "\n" : "\r\n"),
        problems_(name, kMostProblems) {}

  void read() {
    io::CsvRow row;
    if (!rows_.next(row))
      throw Error("there is no header: it must name x1,y1,vx1,vy1,m1,x2,y2,vx2,vy2,m2", problems_.at(0));
    read_header(row);
    problems_.throw_if_any();
    while (rows_.next(row)) read_row(row);
    problems_.throw_if_any();
  }

  void collide(double restitution) {
    rule::collide_batch({.x1 = values_[x1],
                         .y1 = values_[y1],
                         .m1 = values_[m1],
                         .x2 = values_[x2],
                         .y2 = values_[y2],
                         .m2 = values_[m2],
                         .vx1 = values_[vx1],
                         .vy1 = values_[vy1],
                         .vx2 = values_[vx2],
                         .vy2 = values_[vy2]},
                        restitution);
    for (std::size_t k = 0; k < texts_.size(); ++k) {
      const bool finite = std::isfinite(values_[vx1][k]) && std::isfinite(values_[vy1][k]) &&
                          std::isfinite(values_[vx2][k]) && std::isfinite(values_[vy2][k]);
      if (!finite) problems_.add(lines_[k], 1, "the numbers are too large to compute with");
    }
    problems_.throw_if_any();
  }

  [[nodiscard]] std::string text() const {
    fmt::memory_buffer text;
    const auto end = std::back_inserter(text);
    fmt::format_to(end, "{},{}{}", header_, fmt::join(kAppended, ","), line_end_);
    for (std::size_t k = 0; k < texts_.size(); ++k) {
      fmt::format_to(end, "{},{},{},{},{}{}", texts_[k], values_[vx1][k], values_[vy1][k], values_[vx2][k],
                     values_[vy2][k], line_end_);
    }
    return fmt::to_string(text);
  }

 private:
  void read_header(const io::CsvRow& row) {
    header_ = row.text;
    width_ = row.fields.size();
    std::set<std::string_view> names;
    for (std::size_t field = 0; field < width_; ++field) {
      const std::string& name = row.fields[field];
      if (!names.insert(name).second) {
        complain(row, field, fmt::format("column '{}' is there twice", name));
      } else if (std::find(kAppended.begin(), kAppended.end(), name) != kAppended.end()) {
        complain(row, field, fmt::format("column '{}' is there already: it is one of the results", name));
      }
    }
    for (std::size_t quantity = 0; quantity < kQuantities; ++quantity) {
      const auto found = std::find(row.fields.begin(), row.fields.end(), kNames[quantity]);
      if (found == row.fields.end()) {
        problems_.add(row.line, 0, fmt::format("the header has no column '{}'", kNames[quantity]));
      }
      field_of_[quantity] = static_cast<std::size_t>(found - row.fields.begin());
    }
  }

  void read_row(const io::CsvRow& row) {
    if (row.fields.size() != width_) {
      problems_.add(row.line, 1, fmt::format("{} fields: the header has {}", row.fields.size(), width_));
      return;
    }
    const std::size_t before = problems_.size();
    std::array<double, kQuantities> numbers{};
    for (std::size_t quantity = 0; quantity < kQuantities; ++quantity) numbers[quantity] = read_number(row, quantity);
    if (problems_.size() == before) check_distance(row, numbers);
    if (problems_.size() > before) return;
    for (std::size_t quantity = 0; quantity < kQuantities; ++quantity) values_[quantity].push_back(numbers[quantity]);
    texts_.push_back(row.text);
    lines_.push_back(row.line);
  }

  double read_number(const io::CsvRow& row, std::size_t quantity) {
    const std::size_t field = field_of_[quantity];
    const std::string& text = row.fields[field];
    const io::ParsedNumber number = io::parse_number(text);
    const bool is_mass = quantity == m1 || quantity == m2;
    if (!number.fault.empty()) {
      complain(row, field,
               text.empty() ? fmt::format("{} {}", kNames[quantity], number.fault)
                            : fmt::format("{} '{}' {}", kNames[quantity], text, number.fault));
    } else if (is_mass && !(number.value > 0)) {
      complain(row, field, fmt::format("{} is {}: it must be greater than 0", kNames[quantity], number.value));
    }
    return number.value;
  }

  void check_distance(const io::CsvRow& row, const std::array<double, kQuantities>& numbers) {
    const double distance = std::hypot(numbers[x2] - numbers[x1], numbers[y2] - numbers[y1]);
    if (distance == 0) {
      problems_.add(row.line, 1, "both disks have the same centre: there is no normal to collide along");
    } else if (!(distance >= kSmallestDistance && distance <= kLargestDistance)) {
      problems_.add(row.line, 1,
                    fmt::format("the centres are {:.3g} apart: too {} to compute with", distance,
                                distance < 1 ? "close" : "far"));
    }
  }

  void complain(const io::CsvRow& row, std::size_t field, std::string message) {
    problems_.add(row.line, problems_.full() ? 0 : io::column_of_field(row.text, field), std::move(message));
  }

  io::CsvRows rows_;
  std::string_view line_end_;
  io::ProblemList problems_;
  std::string_view header_;
  std::size_t width_ = 0;                            // fields in a row
  std::array<std::size_t, kQuantities> field_of_{};  // each quantity's
  std::array<std::vector<double>, kQuantities> values_;
  std::vector<std::string_view> texts_;
  std::vector<int> lines_;
};

}  // namespace

std::string collide_batch(std::string_view csv, const std::string& name, double restitution) {
  if (!(restitution >= 0 && restitution <= 1)) {
    throw Error(fmt::format("restitution is {}: it must lie in [0, 1]", restitution));
  }
  if (csv.starts_with("\xEF\xBB\xBF")) csv.remove_prefix(3);  // byte order mark
  CollisionTable table(csv, name);
  table.read();
  table.collide(restitution);
  return table.text();
}

}  // namespace carom
