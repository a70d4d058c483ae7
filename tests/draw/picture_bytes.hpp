// What can be read from a picture's bytes without drawing it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace carom::test {

/// True if every tag of the XML text is closed, in order, by the end.
inline bool is_well_formed_xml(std::string_view text) {
  if (text.substr(0, 5) != "<?xml") return false;
  std::vector<std::string> open;
  std::size_t elements = 0;
  for (std::size_t at = text.find('<', 5); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string_view::npos || text.substr(at + 1, end - at - 1).find('<') != std::string_view::npos) {
      return false;
    }
    const std::string_view tag = text.substr(at + 1, end - at - 1);
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.emplace_back(tag.substr(0, tag.find_first_of(" \n")));
    }
    ++elements;
  }
  return open.empty() && elements > 0;
}

inline bool has_numbers_that_are_none(std::string_view svg) {
  return svg.find("nan") != std::string_view::npos || svg.find("inf") != std::string_view::npos;
}

inline std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

struct PathStart {
  double x = 0;
  double y = 0;
};

/// Where each path that is filled with this colour begins, in the order of drawing. Letters are no paths.
inline std::vector<PathStart> filled_paths(const std::string& svg, const std::string& fill) {
  std::vector<PathStart> starts;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) {
    const std::string tag = svg.substr(at, svg.find('>', at) - at);
    if (tag.find(";fill:" + fill + ";") == std::string::npos) continue;
    std::istringstream numbers(tag.substr(tag.find(" d=\"M ") + 6));
    PathStart start;
    numbers >> start.x >> start.y;
    starts.push_back(start);
  }
  return starts;
}

inline bool is_png(std::string_view bytes) {
  return bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n" && bytes.substr(bytes.size() - 8, 4) == "IEND";
}

struct PixelSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

/// From the header of a PNG.
inline PixelSize size_of_png(std::string_view bytes) {
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
  };
  return {number(16), number(20)};
}

inline bool is_pdf(std::string_view bytes) {
  return bytes.substr(0, 5) == "%PDF-" && bytes.find("%%EOF", bytes.size() - 8) != std::string_view::npos;
}

}  // namespace carom::test
