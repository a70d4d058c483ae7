#include "canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cmath>
#include <exception>

#include "carom/base/error.hpp"

namespace carom::draw {
namespace {

constexpr double kPointsPerPixel = 0.75;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) noexcept {
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::exception&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw Error(std::string("cannot draw: ") + cairo_status_to_string(status));
}

cairo_surface_t* make_svg(double width, double height, std::string& bytes) {
  cairo_surface_t* surface = cairo_svg_surface_create_for_stream(append, &bytes, width, height);
  cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
  return surface;
}

cairo_surface_t* make_pdf(double width, double height, std::string& bytes) {
  cairo_surface_t* surface =
      cairo_pdf_surface_create_for_stream(append, &bytes, width * kPointsPerPixel, height * kPointsPerPixel);
  // The same picture gives the same bytes whenever it is made.
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "carom");
  return surface;
}

cairo_surface_t* make_surface(PictureFormat format, double width, double height, double png_scale, std::string& bytes) {
  switch (format) {
    case PictureFormat::svg: return make_svg(width, height, bytes);
    case PictureFormat::pdf: return make_pdf(width, height, bytes);
    case PictureFormat::png: break;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(width * png_scale)),
                                    static_cast<int>(std::lround(height * png_scale)));
}

// Text is laid out alike in every format: no rounding to the pixels of one of them.
void lay_text_out_exactly(cairo_t* ink) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(ink, options);
  cairo_font_options_destroy(options);
}

// Cairo numbers its surfaces over the whole life of a process and writes the number into the SVG.
void forget_surface_number(std::string& svg) {
  const std::string start = "id=\"surface";
  const std::size_t found = svg.find(start);
  if (found == std::string::npos) return;
  const std::size_t digits = found + start.size();
  svg.erase(digits, svg.find('"', digits) - digits);
}

}  // namespace

Canvas::Canvas(PictureFormat format, double width, double height, double png_scale)
    : format_(format),
      width_(width),
      height_(height),
      surface_(make_surface(format, width, height, png_scale, bytes_)),
      ink_(cairo_create(surface_.get())) {
  check(cairo_status(ink_.get()));
  lay_text_out_exactly(ink_.get());
  if (format == PictureFormat::png) cairo_scale(ink_.get(), png_scale, png_scale);
  if (format == PictureFormat::pdf) cairo_scale(ink_.get(), kPointsPerPixel, kPointsPerPixel);
  cairo_set_source_rgb(ink_.get(), 1, 1, 1);
  cairo_paint(ink_.get());
}

std::string Canvas::finish() {
  check(cairo_status(ink_.get()));
  if (format_ == PictureFormat::png) {
    cairo_surface_flush(surface_.get());
    check(cairo_surface_write_to_png_stream(surface_.get(), append, &bytes_));
  } else {
    cairo_show_page(ink_.get());
    cairo_surface_finish(surface_.get());
    check(cairo_surface_status(surface_.get()));
  }
  if (format_ == PictureFormat::svg) forget_surface_number(bytes_);
  return std::move(bytes_);
}

}  // namespace carom::draw
