#include "figures.hpp"

#include "report_support.hpp"

#include <algorithm>
#include <cmath>

using namespace scree;
using namespace scree::report;

TEST_CASE("a long curve keeps its extremes and its ends", "[report]") {
  charts::ChartSeries curve;
  for (int k = 0; k < 100'000; ++k) curve.x.push_back(k), curve.y.push_back(std::sin(1e-4 * k));
  curve.y[31'234] = 5;
  curve.y[71'234] = -5;
  const charts::ChartSeries thin = thinned(curve);
  CHECK(thin.x.size() <= 2000);
  CHECK(thin.x.size() > 600);
  CHECK(thin.x.front() == 0);
  CHECK(thin.x.back() == 99'999);
  CHECK(*std::max_element(thin.y.begin(), thin.y.end()) == 5);
  CHECK(*std::min_element(thin.y.begin(), thin.y.end()) == -5);
  CHECK(std::is_sorted(thin.x.begin(), thin.x.end()));
  CHECK(thinned({"", {1, 2}, {3, 4}}).y == std::vector<double>{3, 4});
}

TEST_CASE("a loop keeps its extremes along both axes", "[report]") {
  charts::ChartSeries loop;
  for (int k = 0; k < 50'000; ++k) loop.x.push_back(std::cos(1e-3 * k)), loop.y.push_back(std::sin(1e-3 * k));
  loop.x[20'001] = 3;
  const charts::ChartSeries thin = thinned(loop);
  CHECK(*std::max_element(thin.x.begin(), thin.x.end()) == 3);
  CHECK(*std::min_element(thin.x.begin(), thin.x.end()) < -0.9999);
}

TEST_CASE("charts are parts of the page with names of their own", "[report]") {
  charts::ChartSpec chart;
  chart.title = "a < b";
  chart.x_label = "x", chart.y_label = "y";
  chart.series.push_back({"curve", {0, 1}, {0, 1}});
  Figures figures;
  figures.add_chart(chart);
  figures.add_chart(chart);
  const std::string html = figures.html();
  CHECK(test::misplaced_tag(html).empty());
  CHECK(html.find("<?xml") == html.npos);
  CHECK(html.find("<figcaption>a &lt; b</figcaption>") != html.npos);
  std::set<std::string> names;
  for (std::size_t at = html.find("id=\""); at != html.npos; at = html.find("id=\"", at + 1))
    CHECK(names.insert(html.substr(at, html.find('"', at + 4) - at)).second);
  CHECK(names.size() > 2);
  // Each reference has its target.
  for (std::size_t at = html.find("href=\"#"); at != html.npos; at = html.find("href=\"#", at + 1))
    CHECK(names.contains("id=\"" + html.substr(at + 7, html.find('"', at + 7) - at - 7)));
}

TEST_CASE("a chart that cannot be drawn is a line", "[report]") {
  Figures figures;
  figures.add_chart({"no curve", "x", "y", {}});
  CHECK_THAT(figures.html(), Catch::Contains("<p class=\"note\">The chart 'no curve' is not drawn: "));
}

TEST_CASE("pictures are PNG files of 1 MB together at most", "[report]") {
  const test::TemporaryFolder folder;
  const std::string png = "\x89PNG\r\n\x1a\n";
  folder.write("a.png", png + std::string(600'000, 'a'));
  folder.write("b.png", png + std::string(600'000, 'b'));
  folder.write("text.png", "<svg onload='x'>");
  Figures figures;
  CHECK_FALSE(figures.has_room_for({folder / "a.png", folder / "b.png"}));
  figures.add_picture(folder / "text.png", "text");
  figures.add_picture(folder / "missing.png", "missing");
  CHECK(figures.empty());
  figures.add_picture(folder / "a.png", "the \"first\"");
  figures.add_picture(folder / "b.png", "the second");
  const std::string html = figures.html();
  CHECK_THAT(html, Catch::Contains("src=\"data:image/png;base64,iVBORw0K"));
  CHECK_THAT(html, Catch::Contains("alt=\"the &quot;first&quot;\""));
  CHECK_THAT(html, !Catch::Contains("the second"));
}
