#include "opened_file.hpp"

#include <algorithm>
#include <numeric>
#include <type_traits>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>
#include <scree/plugin/abi.h>
#include <scree/state_file/description.hpp>

namespace scree::state_file {
namespace {

constexpr std::size_t longest_value = 60;  // characters

template <class T>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<T, std::string>) return "text";
  if constexpr (std::is_same_v<T, double>) return "double";
  if constexpr (std::is_same_v<T, float>) return "float";
  if constexpr (std::is_same_v<T, std::int64_t>) return "int64";
  if constexpr (std::is_same_v<T, std::uint64_t>) return "uint64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "int32";
  if constexpr (std::is_same_v<T, std::uint32_t>) return "uint32";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "uint8";
}

template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
  if constexpr (std::is_same_v<T, std::string>)
    return std::accumulate(values.begin(), values.end(), std::size_t(0),
                           [](std::size_t sum, const std::string& text) { return sum + text.size(); });
  else
    return values.size() * sizeof(T);
}

// The values, separated by commas, if they are few and short; empty otherwise.
template <class T>
std::string short_values(const std::vector<T>& values) {
  std::string text;
  for (const T& value : values) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", value);
    if (text.size() > longest_value) return "";
  }
  return files::escaped(text);
}

// Of the dataset.
std::string shape_of(const PlacedArray& place) {
  if (place.shape.empty()) return place.as_frame ? "1" : "single";
  return fmt::format("{}{}", place.as_frame ? "1 x " : "", fmt::join(place.shape, " x "));
}

std::string line_of(const PlacedArray& place, const StateArray& array, std::size_t width) {
  return std::visit(
      [&]<class T>(const std::vector<T>& values) {
        const std::string shown = short_values(values);
        return fmt::format("  {:<{}}  {:<6}  {:<12}  {:<8}  {:>12} bytes{}{}\n", place.dataset, width,
                           type_name<T>(), shape_of(place), files::one_line(array.unit, longest_value),
                           bytes_of(values), shown.empty() ? "" : "  ", shown);
      },
      array.values);
}

// A line of the summary from the values of an array; none if there is no such array.
std::string summary_line(const State& state, const char* name, const char* path) {
  if (!state.has(path)) return "";
  const StateArray& array = state.at(path);
  const std::string values = std::visit([](const auto& of) { return short_values(of); }, array.values);
  const bool pure = array.unit.empty() || array.unit == "1";
  return fmt::format("{:<12} {}{}{}\n", name, values.empty() ? counted(array.size(), "value") : values,
                     pure ? "" : " ", pure ? "" : files::one_line(array.unit, longest_value));
}

std::string bodies_line(const State& state) {
  const auto found = state.arrays().find("bodies/position");
  if (found == state.arrays().end() || found->second.shape.size() != 2) return "";
  return fmt::format("{:<12} {} in {}D\n", "bodies", found->second.shape[0], found->second.shape[1]);
}

// What the names of the arrays do not say.
std::string notes(const State& state) {
  std::string text;
  if (state.has("bodies/number_in_memory"))
    text +=
        "particles/bodies/number_in_memory: the order in which a run keeps the bodies in memory; all other arrays\n"
        "  list them in the order of the scene\n";
  if (!state.has("contacts/0/a")) return text;
  text +=
      "contacts as a table: scree export --format contacts-csv\n"
      "  scree/contacts/G: pairs a, b that are listed, of bodies, or if planes = 1 of a body and a wall;\n"
      "    row k of history is that of the pair history_row[k]\n";
  if (state.has("contacts/force_row"))
    text += fmt::format(
        "  scree/contacts/force: row k is that of the pair force_row[k], counted from 0 through the groups 0, 1, ...,\n"
        "    each filled up to a multiple of {} pairs; on a\n",
        SCREE_LANES);
  return text;
}

}  // namespace

std::string describe_state_file(const std::filesystem::path& path) {
  const OpenedFile file(path);
  std::vector<PlacedArray> places = file.places();
  const State state = file.state(places);
  const Seal& seal = file.seal();
  std::string text = fmt::format(
      "{}: state written by scree {}, format {}, {} bytes, checksum {:016x}\n", files::escaped(path.string()),
      files::one_line(seal.program_version, longest_value), seal.format, seal.bytes, seal.checksum);
  text += summary_line(state, "time", "clock/time");
  text += summary_line(state, "steps", "clock/steps");
  text += bodies_line(state);
  text += summary_line(state, "materials", "scene/materials");
  text += summary_line(state, "laws", "scene/law_plugins");
  text += summary_line(state, "walls", "scene/boundary_plugins");
  text += summary_line(state, "integrator", "scene/integrator");
  text += summary_line(state, "stages done", "run/stages/stage");
  std::sort(places.begin(), places.end(), [](const auto& p, const auto& q) { return p.dataset < q.dataset; });
  std::size_t width = 0;
  for (const PlacedArray& place : places) width = std::max(width, place.dataset.size());
  text += counted(places.size(), "array") + ", by their paths in HDF5\n";
  for (const PlacedArray& place : places) text += line_of(place, state.at(place.path), width);
  return text + notes(state);
}

}  // namespace scree::state_file
