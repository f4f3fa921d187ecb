#include "../backend.hpp"
#include "drawable_chart.hpp"
#include "drawing.hpp"
#include "layout.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <functional>
#include <memory>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::charts {
namespace {

// Of charts without pixels (pt); labels are as large as the text around them in a paper.
constexpr double page_width = 480, page_height = page_width * chart_height / chart_width;

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(fmt::format("chart: cairo cannot draw it ({}); free memory", cairo_status_to_string(status)),
                ExitStatus::failure);
}

void draw_on(cairo_surface_t* surface, double scale, const ChartSpec& spec, const Layout& layout) {
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface), cairo_destroy);
  cairo_scale(cairo.get(), scale, scale);
  draw(cairo.get(), spec, layout);
  check(cairo_status(cairo.get()));
}

std::string png(const ChartSpec& spec, const Layout& layout) {
  std::string bytes;
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, int(chart_width), int(chart_height)),
                        cairo_surface_destroy);
  draw_on(surface.get(), 1, spec, layout);
  check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  return bytes;
}

// A file of a page; make: creates the surface that writes to the bytes.
std::string page(const ChartSpec& spec, const Layout& layout,
                 const std::function<cairo_surface_t*(std::string&)>& make) {
  std::string bytes;
  const Surface surface(make(bytes), cairo_surface_destroy);
  draw_on(surface.get(), page_width / chart_width, spec, layout);
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return bytes;
}

std::string pdf(const ChartSpec& spec, const Layout& layout) {
  return page(spec, layout, [&](std::string& bytes) {
    cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(append, &bytes, page_width, page_height);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, spec.title.c_str());
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                   nullptr);  // the same bytes at any time
    return surface;
  });
}

std::string xml(const std::string& text) {
  std::string escaped;
  for (const char c : text)
    escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return escaped;
}

// The letters are outlines, as cairo writes them; title and description are what a search or a screen reader
// finds.
std::string svg(const ChartSpec& spec, const Layout& layout) {
  std::string bytes = page(spec, layout, [](std::string& target) {
    return cairo_svg_surface_create_for_stream(append, &target, page_width, page_height);
  });
  std::string words = fmt::format("{} over {}", spec.y_label, spec.x_label);
  if (spec.series.size() > 1)
    for (const ChartSeries& series : spec.series) words += "; " + series.name;
  // cairo numbers the surfaces of the process.
  constexpr std::string_view id = "id=\"surface";
  if (const std::size_t at = bytes.find(id); at != std::string::npos)
    bytes.replace(at, bytes.find('"', at + id.size()) - at, "id=\"chart");
  const std::size_t root = bytes.find('>', bytes.find("<svg"));
  return bytes.insert(root + 1,
                      fmt::format("\n<title>{}</title>\n<desc>{}</desc>", xml(spec.title), xml(words)));
}

class CairoBackend final : public ChartBackend {
 public:
  std::string draw(const ChartSpec& spec, std::string_view format) override {
    std::string note;
    const ChartSpec drawable = drawable_chart(spec, note);
    const Layout layout = Layout::of(drawable, note);
    return format == "png"   ? png(drawable, layout)
           : format == "svg" ? svg(drawable, layout)
                             : pdf(drawable, layout);
  }
};

}  // namespace
}  // namespace scree::charts

// Returns null if the program was built against another version of the interface.
extern "C" __attribute__((visibility("default"))) scree::charts::ChartBackend* scree_create_chart_backend(
    int version) {
  return version == scree::charts::backend_version ? new scree::charts::CairoBackend : nullptr;
}
