#include "opened_file.hpp"

#include <algorithm>
#include <numeric>
#include <type_traits>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>
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

std::string shape_of(const StateArray& array) {
  return array.shape.empty() ? "single" : fmt::format("{}", fmt::join(array.shape, " x "));
}

std::string line_of(const std::string& path, const StateArray& array, std::size_t width) {
  return std::visit(
      [&]<class T>(const std::vector<T>& values) {
        const std::string shown = short_values(values);
        return fmt::format("  {:<{}}  {:<6}  {:<12}  {:<8}  {:>12} bytes{}{}\n", path, width, type_name<T>(),
                           shape_of(array), files::one_line(array.unit, longest_value), bytes_of(values),
                           shown.empty() ? "" : "  ", shown);
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

}  // namespace

std::string describe_state_file(const std::filesystem::path& path) {
  const OpenedFile file(path);
  const State state = file.state();
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
  std::size_t width = 0;
  for (const auto& [name, array] : state.arrays()) width = std::max(width, name.size());
  text += counted(state.arrays().size(), "array") + "\n";
  for (const auto& [name, array] : state.arrays()) text += line_of(name, array, width);
  return text;
}

}  // namespace scree::state_file
