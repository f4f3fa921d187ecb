#include "bodies_drawing.hpp"

#include "html.hpp"
#include "numbers.hpp"
#include "text_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace scree::report {

namespace {

constexpr double width = 1200, height = 900, margin = 60;  // of the drawing, as of charts

struct Disc {
  double x, y, depth, radius;
  std::size_t material;
};

// The range of a coordinate of all discs.
struct Range {
  double low = INFINITY, high = -INFINITY;

  void add(double from, double to) { low = std::min(low, from), high = std::max(high, to); }
  double size() const { return high - low; }
};

// In 3D z is up, and the wider of x and y goes to the right.
std::vector<Disc> discs_of(const TextTable& table) {
  const bool is_flat = !table.has("z");
  std::array<Range, 2> ranges;
  for (std::size_t row = 0; row < table.rows(); ++row)
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (const double at = table.number(row, axis ? "y" : "x"); std::isfinite(at)) ranges[axis].add(at, at);
  const bool along_y = !is_flat && ranges[1].size() > 1.5 * ranges[0].size();
  std::vector<std::string> materials;
  std::vector<Disc> discs;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& material = table.text(row, "material");
    auto found = std::find(materials.begin(), materials.end(), material);
    if (found == materials.end()) found = materials.insert(materials.end(), material);
    const Disc disc = {table.number(row, along_y ? "y" : "x"), table.number(row, is_flat ? "y" : "z"),
                       is_flat ? 0 : table.number(row, along_y ? "x" : "y"), table.number(row, "radius"),
                       std::size_t(found - materials.begin())};
    if (std::isfinite(disc.x + disc.y + disc.depth + disc.radius)) discs.push_back(disc);
  }
  // Along y it is seen from the end of the x axis, so that y goes to the right.
  std::stable_sort(discs.begin(), discs.end(), [&](const Disc& a, const Disc& b) {
    return along_y ? a.depth < b.depth : a.depth > b.depth;
  });
  return discs;
}

// From the first of the palette, paler by a share.
std::string color_of(std::size_t material, double pale) {
  static constexpr std::array<std::array<int, 3>, 5> palette = {
      {{72, 120, 168}, {214, 140, 70}, {90, 158, 120}, {176, 122, 161}, {140, 140, 140}}};
  const auto& color = palette[material % palette.size()];
  const auto channel = [&](int value) { return int(value + pale * (255 - value)); };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(color[0]), channel(color[1]), channel(color[2]));
}

// A bar of a round length, about a fifth of the drawing. scale: units of the drawing per metre.
std::string scale_bar(double scale) {
  const double wanted = width / 5 / scale, decade = std::pow(10.0, std::floor(std::log10(wanted)));
  const double length = wanted >= 5 * decade ? 5 * decade : wanted >= 2 * decade ? 2 * decade : decade;
  const double y = height - 24;
  return fmt::format(
      "<path d=\"M{0:.1f} {1:.1f}h{2:.1f}\" stroke=\"#1c2024\" stroke-width=\"4\"/>\n"
      "<text x=\"{3:.1f}\" y=\"{4:.1f}\" font-size=\"24\" fill=\"#1c2024\">{5}</text>\n",
      margin, y, length * scale, margin + length * scale + 14, y + 8, with_unit(length, "m", 3));
}

}  // namespace

std::string bodies_drawing(const std::filesystem::path& packing) {
  constexpr std::size_t most_bodies = 2000;
  constexpr std::uintmax_t longest_row = 400;  // (bytes)
  std::error_code failed;
  if (std::filesystem::file_size(packing, failed) > most_bodies * longest_row || failed) return "";
  const std::vector<Disc> discs = discs_of(TextTable(packing));
  if (discs.empty() || discs.size() > most_bodies) return "";
  Range x, y;
  for (const Disc& disc : discs) {
    x.add(disc.x - disc.radius, disc.x + disc.radius);
    y.add(disc.y - disc.radius, disc.y + disc.radius);
  }
  const double scale = std::min((width - 2 * margin) / x.size(), (height - 2 * margin) / y.size());
  if (!std::isfinite(scale) || !(scale > 0)) return "";
  const double left = (width - scale * x.size()) / 2, bottom = (height + scale * y.size()) / 2;
  const double far = discs.front().depth, near = discs.back().depth;
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\">\n<title>The bodies at the end</title>\n"
      "<g stroke=\"#fff\" stroke-width=\"1\">\n",
      width, height);
  for (const Disc& disc : discs) {
    const double pale = far == near ? 0.15 : 0.6 * (disc.depth - near) / (far - near);
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>\n",
                       left + scale * (disc.x - x.low), bottom - scale * (disc.y - y.low),
                       scale * disc.radius, color_of(disc.material, pale));
  }
  return svg + "</g>\n" + scale_bar(scale) + "</svg>";
}

}  // namespace scree::report
