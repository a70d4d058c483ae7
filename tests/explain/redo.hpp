// A student with an exact calculator: reads a derivation in plain text and redoes every line of it.
#pragma once

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <map>
#include <string>
#include <vector>

namespace redo {

using Number = boost::multiprecision::cpp_dec_float_100;

/// A number (one component) or a vector (two).
using Value = std::vector<Number>;

/// What came out of redoing a derivation.
struct Report {
  std::vector<std::string> mistakes;    ///< lines that do not add up, with the reason
  int relations = 0;                    ///< = and ≈ that were checked
  std::map<std::string, Value> values;  ///< every symbol as it was printed last
  std::vector<std::string> tags;        ///< equation numbers, in order
};

/// Redoes the mathematics of `text`: members joined by = must be equal exactly, those joined by ≈ must not be equal
/// but agree within half a unit of the eighth digit of every number shown. Symbols stand for the numbers printed above.
Report redo(const std::string& text);

}  // namespace redo
