#include "backend.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/charts/draw_chart.hpp>
#include <scree/error.hpp>
#include <scree/files/companion_library.hpp>
#include <scree/files/text_file.hpp>

namespace scree::charts {
namespace {

constexpr files::CompanionLibrary library = {
    .target = "scree_charts_cairo",
    .factory = "scree_create_chart_backend",
    .purpose = "charts",
    .without = "leave them out",
    .needs = "the cairo run-time library (apt install libcairo2)",
};

ChartBackend& backend() {
  static ChartBackend* const loaded = files::load_companion<ChartBackend>(library, backend_version);
  return *loaded;
}

}  // namespace

void draw_chart(const ChartSpec& spec, const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  const std::string format = extension.empty() ? "" : extension.substr(1);
  if (std::find(chart_formats.begin(), chart_formats.end(), format) == chart_formats.end())
    throw Error(fmt::format("{}: is no name of a chart; give one that ends in .{}", file.string(),
                            fmt::join(chart_formats, ", .")));
  files::write_in_folder(file, chart_bytes(spec, format));
}

std::string chart_bytes(const ChartSpec& spec, std::string_view format) {
  return backend().draw(spec, format);
}

}  // namespace scree::charts
