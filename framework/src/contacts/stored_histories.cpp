#include "contacts/stored_histories.hpp"

#include "contacts/contacts.hpp"

#include <vector>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/scene_record.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

namespace {

// Some states of earlier versions have histories of float.
std::vector<double> as_double(const StateArray& array) {
  std::vector<double> numbers;
  std::visit(
      [&]<class T>(const std::vector<T>& stored) {
        if constexpr (std::is_floating_point_v<T>) numbers.assign(stored.begin(), stored.end());
      },
      array.values);
  return numbers;
}

void visit_group(const State& state, const StateTransfer& group, const std::string& path,
                 const std::vector<std::string>& plugins,
                 const std::function<void(const StoredHistory&)>& visit) {
  std::uint32_t law = 0;
  bool planes = false;
  std::vector<std::uint32_t> a, b, rows;
  std::vector<std::uint8_t> image;
  group.value("law", "", law);
  group.value("planes", "", planes);
  group.rows("a", "", a);
  group.rows("b", "", b);
  group.rows("image", "", image);
  group.rows("history_row", "", rows);
  const std::vector<double> numbers = as_double(state.at(path + "/history"));
  if (law >= plugins.size() || a.size() != b.size() || a.size() != image.size() ||
      (rows.empty() ? 0 : numbers.size() % rows.size()))
    group.refuse("history", "does not fit the pairs of its group");
  const std::size_t width = rows.empty() ? 0 : numbers.size() / rows.size();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r] >= a.size()) group.refuse("history_row", "lists a pair that there is not");
    if (planes && image[rows[r]] < Domain::no_shift) group.refuse("image", "has an image of a wall");
    const std::uint32_t spot = planes ? spot_of_image(image[rows[r]]) : 0;
    visit({plugins[law], planes, a[rows[r]], b[rows[r]], spot, std::span(numbers).subspan(r * width, width)});
  }
}

}  // namespace

void each_history(const State& state, const std::function<void(const StoredHistory&)>& visit) {
  const StateTransfer all = StateTransfer::restoring_from(state);
  std::vector<std::string> plugins;
  for (const RecordedPlugin& law : recorded_laws(state)) plugins.push_back(law.plugin);
  for (std::size_t g = 0; state.has(fmt::format("contacts/{}/law", g)); ++g) {
    const std::string path = fmt::format("contacts/{}", g);
    if (state.has(path + "/history")) visit_group(state, all.below(path), path, plugins, visit);
  }
}

}  // namespace scree
