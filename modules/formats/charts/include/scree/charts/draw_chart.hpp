#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include <scree/charts/chart_spec.hpp>

namespace scree::charts {

// Formats of charts, which are the extensions of their files: pixels, or curves and letters of any size.
inline constexpr std::array<std::string_view, 3> chart_formats = {"png", "svg", "pdf"};

// Draws a chart to a file in the format of its extension: 1200 x 900 pixels, or 480 x 360 pt. The folder of
// the file is created, but none above; the file gets its name only when it is complete. The same chart has
// the same bytes on every machine with the same cairo. Loads cairo at the first call. Not thread-safe. Throws
// Error if a series is empty, has x and y of different length, or no point that can be drawn, and if the file
// cannot be written.
void draw_chart(const ChartSpec& spec, const std::filesystem::path& file);

// The bytes of such a file in one of chart_formats, for a chart that is part of another document.
std::string chart_bytes(const ChartSpec& spec, std::string_view format);

}  // namespace scree::charts
