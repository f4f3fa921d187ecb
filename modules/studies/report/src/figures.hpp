#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scree/charts/chart_spec.hpp>

namespace scree::report {

// The charts and pictures of a page, as parts of it.
class Figures {
 public:
  // A chart as SVG, its title below it. One that cannot be drawn is a line that says why.
  void add_chart(charts::ChartSpec chart);
  // A line in the place of a chart that is not drawn.
  void add_line(const std::string& text) { html_ += "<p class=\"note\">" + text + "</p>\n"; }
  bool has_room_for(const std::vector<std::filesystem::path>& files) const;
  // A PNG file, unless it is none or larger than what is left of 1 MB for all of these pictures.
  void add_picture(const std::filesystem::path& file, const std::string& caption);

  // An <svg>; nothing if it is empty.
  void add_drawing(const std::string& svg, const std::string& caption);

  bool empty() const { return html_.empty(); }
  // Side by side where there is room.
  std::string html() const;

 private:
  std::string html_;
  std::size_t room_ = 1u << 20;  // (bytes)
  // Names of the parts of a chart are those of the whole page.
  std::size_t charts_ = 0;
};

// A curve with at most about 2000 points, which looks the same: of each of equal parts of the points, the
// first, the last, and those that are the furthest left, right, up and down.
charts::ChartSeries thinned(charts::ChartSeries curve);

}  // namespace scree::report
