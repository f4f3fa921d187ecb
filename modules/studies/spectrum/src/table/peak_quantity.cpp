#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/files/text.hpp>
#include <scree/nearest.hpp>
#include <scree/spectrum/peak_quantity.hpp>

namespace scree::spectrum {

namespace {

constexpr std::string_view prefix = "peaks.", ascii_lambda = "lambda", numbered = "peak_";

bool has_layers(const std::vector<ObservedColumn>& observed) {
  return responding(observed) < observed.size();
}

// Takes one of the words and a dot off the front of a text.
template <class Words>
std::optional<std::size_t> take_word(std::string_view& text, const Words& words) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string with_dot = std::string(words[k]) + ".";
    if (!text.starts_with(with_dot)) continue;
    text.remove_prefix(with_dot.size());
    return k;
  }
  return std::nullopt;
}

std::vector<std::string> responding_names(const std::vector<ObservedColumn>& observed) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < responding(observed); ++c) names.push_back(observed[c].name);
  return names;
}

bool is_count(std::string_view text) {
  return !text.empty() && text[0] != '0' &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

// "<n>λ/<m>" with n and m left out if they are 1.
bool is_shape_name(const std::string& name) {
  const std::string_view lambda = "λ";
  const std::size_t at = name.find(lambda);
  if (at == name.npos) return false;
  const std::string_view before = std::string_view(name).substr(0, at),
                         behind = std::string_view(name).substr(at + lambda.size());
  return (before.empty() || is_count(before)) && (behind.empty() || behind == "/2" || behind == "/4");
}

std::optional<std::string> peak_of(std::string_view text, const std::vector<ObservedColumn>& observed) {
  std::string name(text);
  if (const std::size_t at = name.find(ascii_lambda); at != name.npos)
    name.replace(at, ascii_lambda.size(), "λ");
  const bool by_number = text.starts_with(numbered) && is_count(text.substr(numbered.size()));
  if (by_number || (has_layers(observed) && is_shape_name(name))) return name;
  return std::nullopt;
}

}  // namespace

bool names_peak(std::string_view quantity) { return quantity.starts_with(prefix); }

std::optional<PeakQuantity> peak_quantity(std::string_view name,
                                          const std::vector<ObservedColumn>& observed) {
  if (!names_peak(name)) return std::nullopt;
  name.remove_prefix(prefix.size());
  const auto method = take_word(name, method_names);
  if (!method) return std::nullopt;
  const auto column = take_word(name, responding_names(observed));
  const std::size_t dot = name.find('.');
  if (!column || dot == name.npos) return std::nullopt;
  const auto peak = peak_of(name.substr(0, dot), observed);
  const auto number = std::find(peak_numbers.begin(), peak_numbers.end(), name.substr(dot + 1));
  if (!peak || number == peak_numbers.end()) return std::nullopt;
  return PeakQuantity{*method, *column, *peak, std::size_t(number - peak_numbers.begin())};
}

std::vector<std::string> peak_quantity_names(const std::vector<ObservedColumn>& observed) {
  std::vector<std::string> peaks, all;
  for (int k = 1; k <= 9; ++k) peaks.push_back(fmt::format("{}{}", numbered, k));
  if (has_layers(observed))
    peaks.insert(peaks.end(), {"λ/4", "λ/2", "3λ/4", "λ", "5λ/4", "3λ/2", "7λ/4", "2λ"});
  for (const char* method : method_names)
    for (const std::string& column : responding_names(observed))
      for (const std::string& peak : peaks)
        for (const char* number : peak_numbers)
          all.push_back(fmt::format("{}{}.{}.{}.{}", prefix, method, column, peak, number));
  return all;
}

std::optional<std::string> peak_quantity_problem(const std::string& name,
                                                 const std::vector<ObservedColumn>& observed) {
  if (peak_quantity(name, observed)) return std::nullopt;
  const std::string problem = fmt::format("no quantity '{}'", files::one_line(name));
  if (!has_layers(observed) && (name.find("λ") != name.npos || name.find(ascii_lambda) != name.npos))
    return problem + " without shapes; give spectrum.shape_from, or peak_1, peak_2, ... in place of λ";
  if (const auto near = nearest_word(name, peak_quantity_names(observed)))
    return fmt::format("{}; did you mean '{}'?", problem, *near);
  return fmt::format("{}; give {}<{}>.<{}>.<peak_1, peak_2, ...{}>.<{}>", problem, prefix,
                     fmt::join(method_names, ", "), fmt::join(responding_names(observed), ", "),
                     has_layers(observed) ? " or 3lambda/4, ..." : "", fmt::join(peak_numbers, ", "));
}

}  // namespace scree::spectrum
