#include "carom/draw/format.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "carom/base/error.hpp"

namespace carom {
namespace {

char lower(char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter; }

bool ends_in(std::string_view path, std::string_view ending) {
  return path.size() >= ending.size() && std::equal(ending.rbegin(), ending.rend(), path.rbegin(),
                                                    [](char wanted, char found) { return wanted == lower(found); });
}

}  // namespace

PictureFormat picture_format_of(const std::string& path) {
  constexpr std::array<std::pair<std::string_view, PictureFormat>, 3> kEndings{
      {{".svg", PictureFormat::svg}, {".png", PictureFormat::png}, {".pdf", PictureFormat::pdf}}};
  for (const auto& [ending, format] : kEndings) {
    if (ends_in(path, ending)) return format;
  }
  throw Error("cannot draw to " + path + ": give a name that ends in .svg, .png or .pdf");
}

}  // namespace carom
