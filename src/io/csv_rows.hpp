// Rows of a CSV text with their fields, their own bytes and where they stand. libcsv knows CSV's rules; it does not
// tell where in the text a field came from, which is what this adds.
#pragma once

#include <csv.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace carom::io {

struct CsvRow {
  std::vector<std::string> fields;  ///< without quotes and the blanks around them
  std::string_view text;            ///< as it stands in the file, without its line end
  int line = 0;                     ///< on which it begins, counted from 1
};

class CsvRows {
 public:
  /// `text` must outlive this; `name` is what messages call it.
  CsvRows(std::string_view text, std::string name);
  ~CsvRows();
  CsvRows(const CsvRows&) = delete;
  CsvRows& operator=(const CsvRows&) = delete;

  /// Goes to the next row that is not blank; false at the end. Throws Error if its quotes are broken: what follows
  /// such a row cannot be told apart. The row's text is valid as long as the whole text.
  bool next(CsvRow& row);

 private:
  std::string_view take_line();

  std::string name_;
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 0;
  csv_parser parser_{};
};

/// Column (of the first byte, counted from 1) in which the field with this index begins.
int column_of_field(std::string_view row, std::size_t index);

}  // namespace carom::io
