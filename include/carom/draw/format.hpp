// The kinds of picture that carom makes.
#pragma once

#include <string>

namespace carom {

enum class PictureFormat { svg, png, pdf };

/// The format that a file's name ends in: .svg, .png or .pdf, in either case.
/// Throws Error "cannot draw to FILE: give a name that ends in .svg, .png or .pdf" for any other.
PictureFormat picture_format_of(const std::string& path);

}  // namespace carom
