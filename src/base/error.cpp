#include "carom/base/error.hpp"

#include <utility>

namespace carom {
namespace {

std::string join_lines(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += to_string(problem);
  }
  return text;
}

}  // namespace

std::string to_string(const Place& place) {
  if (place.file.empty()) return {};
  std::string text = place.file;
  if (place.line > 0) text += ':' + std::to_string(place.line);
  if (place.line > 0 && place.column > 0) text += ':' + std::to_string(place.column);
  return text;
}

std::string to_string(const Problem& problem) {
  const std::string where = to_string(problem.place);
  return where.empty() ? problem.message : where + ": " + problem.message;
}

Error::Error(const std::string& message, Place place)
    : Error(std::vector<Problem>{Problem{message, std::move(place)}}) {}

Error::Error(std::vector<Problem> problems)
    : std::runtime_error(join_lines(problems)), problems_(std::move(problems)) {}

}  // namespace carom
