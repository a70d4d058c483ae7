#include "csv_rows.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "carom/base/error.hpp"

namespace carom::io {
namespace {

/// What libcsv's callbacks fill.
struct Collected {
  std::vector<std::string>* fields = nullptr;
  bool row_ended = false;
};

void on_field(void* bytes, std::size_t size, void* data) {
  static_cast<Collected*>(data)->fields->emplace_back(static_cast<const char*>(bytes), size);
}

void on_row_end(int, void* data) { static_cast<Collected*>(data)->row_ended = true; }

constexpr unsigned char kOptions = CSV_STRICT | CSV_STRICT_FINI;

bool is_blank(std::string_view line) noexcept { return line.find_first_not_of(" \t\r\n") == std::string_view::npos; }

}  // namespace

CsvRows::CsvRows(std::string_view text, std::string name) : name_(std::move(name)), text_(text) {
  if (csv_init(&parser_, kOptions) != 0) throw std::bad_alloc();
}

CsvRows::~CsvRows() { csv_free(&parser_); }

/// The next line with its end: a line feed, a carriage return, or both.
std::string_view CsvRows::take_line() {
  std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  if (end < text_.size()) end += text_.substr(end, 2) == "\r\n" ? 2 : 1;
  ++line_;
  const std::string_view line = text_.substr(at_, end - at_);
  at_ = end;
  return line;
}

bool CsvRows::next(CsvRow& row) {
  row.fields.clear();
  Collected collected{&row.fields};
  std::size_t begin = at_;
  bool begun = false;
  while (at_ < text_.size() && !collected.row_ended) {
    const std::string_view line = take_line();
    if (!begun && is_blank(line)) {
      begin = at_;
      continue;
    }
    if (!std::exchange(begun, true)) row.line = line_;
    const std::size_t parsed = csv_parse(&parser_, line.data(), line.size(), on_field, on_row_end, &collected);
    if (parsed != line.size()) {
      const auto column = static_cast<int>(parsed) + 1;
      throw Error("a quotation mark stands where CSV allows none", {name_, line_, column});
    }
  }
  if (!begun) return false;
  if (!collected.row_ended && csv_fini(&parser_, on_field, on_row_end, &collected) != 0) {
    throw Error("a quotation mark is not closed before the file's end", {name_, row.line, 0});
  }
  const std::size_t end = text_.find_last_not_of("\r\n", at_ - 1);
  row.text = text_.substr(begin, end + 1 - begin);
  return true;
}

int column_of_field(std::string_view row, std::size_t index) {
  csv_parser parser{};
  if (csv_init(&parser, kOptions) != 0) throw std::bad_alloc();
  std::vector<std::string> fields;
  Collected collected{&fields};
  std::size_t at = 0;
  for (; at < row.size() && fields.size() < index; ++at) {
    csv_parse(&parser, row.data() + at, 1, on_field, on_row_end, &collected);
  }
  csv_free(&parser);
  const std::size_t begin = row.find_first_not_of(" \t", at);
  return static_cast<int>(std::min(begin, row.size())) + 1;
}

}  // namespace carom::io
