#include "problem_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace carom::io {

void ProblemList::add(int line, int column, std::string message) {
  if (++found_ <= most_) problems_.push_back({std::move(message), at(line, column)});
}

std::vector<Problem> ProblemList::in_order() const {
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  if (found_ > most_) sorted.push_back({fmt::format("… and {} more problems", found_ - most_), at(0)});
  return sorted;
}

void ProblemList::throw_if_any() const {
  if (found_ > 0) throw Error(in_order());
}

}  // namespace carom::io
