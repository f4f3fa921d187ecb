#include "figures.hpp"

#include "html.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <scree/charts/draw_chart.hpp>
#include <scree/files/text_file.hpp>

namespace scree::report {

namespace {

// Puts `prefix` before the names of the parts of a chart, where they are given and where they are used.
std::string with_prefix(const std::string& svg, const std::string& prefix) {
  constexpr std::array<std::string_view, 3> before = {"id=\"", "href=\"#", "url(#"};
  std::string text;
  for (std::size_t k = 0; k < svg.size();) {
    const auto is_here = [&](std::string_view name) { return svg.compare(k, name.size(), name) == 0; };
    const auto found = std::find_if(before.begin(), before.end(), is_here);
    if (found == before.end()) {
      text += svg[k++];
    } else {
      text.append(*found).append(prefix);
      k += found->size();
    }
  }
  return text;
}

// The <svg> of a file, as wide as its place on the page.
std::string inline_svg(const std::string& file, const std::string& prefix) {
  const std::size_t begin = file.find("<svg"), end = file.find('>', begin);
  if (begin == file.npos || end == file.npos) return "";
  std::string tag = file.substr(begin, end - begin);
  for (const char* size : {" width=\"", " height=\""})
    if (const std::size_t at = tag.find(size); at != tag.npos)
      tag.erase(at, tag.find('"', at + std::string_view(size).size()) + 1 - at);
  return with_prefix(tag + " role=\"img\"" + file.substr(end), prefix);
}

std::string figure(const std::string& html, const std::string& caption) {
  return fmt::format("<figure>\n{}\n<figcaption>{}</figcaption>\n</figure>\n", html, escaped(caption));
}

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }

}  // namespace

void Figures::add_chart(charts::ChartSpec chart) {
  const std::string title = chart.title;
  for (charts::ChartSeries& series : chart.series) series = thinned(std::move(series));
  chart.title.clear();  // it is the caption
  try {
    const std::string svg = charts::chart_bytes(chart, "svg");
    html_ += figure(inline_svg(svg, fmt::format("c{}-", ++charts_)), title);
  } catch (const std::exception& error) {
    add_line(escaped(fmt::format("The chart '{}' is not drawn: {}", title, error.what())));
  }
}

void Figures::add_drawing(const std::string& svg, const std::string& caption) {
  if (!svg.empty()) html_ += figure(svg, caption);
}

bool Figures::has_room_for(const std::vector<std::filesystem::path>& files) const {
  std::uintmax_t size = 0;
  std::error_code failed;
  for (const std::filesystem::path& file : files) {
    size += std::filesystem::file_size(file, failed);
    if (failed || size > room_) return false;
  }
  return true;
}

void Figures::add_picture(const std::filesystem::path& file, const std::string& caption) {
  if (!has_room_for({file})) return;
  try {
    const std::string bytes = files::read_text(file, room_);
    if (!is_png(bytes)) return;
    room_ -= std::min(room_, bytes.size());
    html_ += figure(
        fmt::format("<img src=\"data:image/png;base64,{}\" alt=\"{}\">", base64(bytes), escaped(caption)),
        caption);
  } catch (const Error&) {
    // It was removed since.
  }
}

std::string Figures::html() const {
  return html_.empty() ? "" : fmt::format("<div class=\"figures\">\n{}</div>\n", html_);
}

charts::ChartSeries thinned(charts::ChartSeries curve) {
  constexpr std::size_t most_points = 2000, of_part = 6, parts = most_points / of_part;
  const std::size_t count = std::min(curve.x.size(), curve.y.size());
  if (count <= most_points || !curve.y_error.empty()) return curve;
  charts::ChartSeries thin = curve;
  thin.x.clear(), thin.y.clear();
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t begin = part * count / parts, end = (part + 1) * count / parts;
    std::array<std::size_t, of_part> kept;
    kept.fill(begin);
    kept.back() = end - 1;
    for (std::size_t k = begin; k < end; ++k) {
      // Comparisons with NaN are false: a gap at the beginning of a part stays.
      if (curve.x[k] < curve.x[kept[1]]) kept[1] = k;
      if (curve.x[k] > curve.x[kept[2]]) kept[2] = k;
      if (curve.y[k] < curve.y[kept[3]]) kept[3] = k;
      if (curve.y[k] > curve.y[kept[4]]) kept[4] = k;
    }
    std::sort(kept.begin(), kept.end());
    for (std::size_t k = 0; k < kept.size(); ++k)
      if (k == 0 || kept[k] != kept[k - 1])
        thin.x.push_back(curve.x[kept[k]]), thin.y.push_back(curve.y[kept[k]]);
  }
  return thin;
}

}  // namespace scree::report
