#include "scene_pictures.hpp"

#include "bodies_drawing.hpp"
#include "figures.hpp"
#include "html.hpp"
#include "numbers.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/report/record.hpp>

namespace scree::report {

namespace fs = std::filesystem;

namespace {

// PNG files of a folder, by name.
std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// "After 17 261 steps, t = 0.1 s" for frame_0000017261.png; the name of any other file.
std::string caption_of(const fs::path& file, double step) {
  const std::string name = file.stem().string();
  constexpr std::string_view prefix = "frame_";
  std::uint64_t steps = 0;
  const char* const end = name.data() + name.size();
  if (!name.starts_with(prefix)) return name;
  const auto [rest, failed] = std::from_chars(name.data() + prefix.size(), end, steps);
  if (failed != std::errc() || rest != end) return name;
  if (steps == 0) return "At the start";
  return fmt::format("After {} steps, t = {}", count_text(double(steps)),
                     with_unit(double(steps) * step, "s", 3));
}

}  // namespace

std::string scene_pictures(const Results& results) {
  const std::vector<fs::path> files = pictures_in(results.directory / "images");
  const double step = number_in(results.record, "step");
  Figures figures;
  if (files.empty()) {
    figures.add_drawing(bodies_drawing(results.directory / "final_packing.csv"), "The bodies at the end");
    return figures.html();
  }
  // The last one is the one to have if there is room for one only.
  if (files.size() > 1 && figures.has_room_for({files.front(), files.back()}))
    figures.add_picture(files.front(), caption_of(files.front(), step));
  figures.add_picture(files.back(), caption_of(files.back(), step));
  return figures.html();
}

}  // namespace scree::report
