#include "mode_group.hpp"

#include <algorithm>

namespace scree::signals {

namespace {

constexpr std::size_t least_points = 4;  // in the width of a mode

}  // namespace

std::size_t index_of(const Response& response, double frequency) {
  const auto& f = response.frequencies;
  return std::size_t(std::lower_bound(f.begin(), f.end(), frequency) - f.begin());
}

Range range_about(const Response& response, const Pole& pole, double widths) {
  return {index_of(response, pole.frequency - widths * pole.width),
          index_of(response, pole.frequency + widths * pole.width),
          {pole}};
}

Response part(const Response& whole, const Range& range) {
  const auto cut = [&](const auto& all) {
    return std::remove_cvref_t<decltype(all)>(all.begin() + std::ptrdiff_t(range.begin),
                                              all.begin() + std::ptrdiff_t(range.end));
  };
  return {cut(whole.frequencies), cut(whole.values), whole.only_amplitudes, whole.derivative};
}

bool is_within(const Pole& pole, const Response& response) {
  const double low = response.frequencies.front(), high = response.frequencies.back();
  const std::size_t within = index_of(response, pole.frequency + 0.5 * pole.width) -
                             index_of(response, pole.frequency - 0.5 * pole.width);
  return pole.frequency > low && pole.frequency < high && within >= least_points && pole.width < high - low;
}

void subtract(const Pole& pole, Response& response) {
  for (std::size_t k = 0; k < response.values.size(); ++k) {
    const double f = response.frequencies[k];
    response.values[k] -= response.factor(f) * pole.strength /
                          std::complex((pole.frequency - f) * (pole.frequency + f), f * pole.width);
  }
}

Response alone(const Response& whole, const std::vector<Group>& groups, std::size_t number,
               const Range& range) {
  Response response = part(whole, range);
  if (whole.only_amplitudes) return response;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (g == number || !groups[g].fit.converged) continue;
    const Response of_other = part(whole, groups[g].range);
    for (const Pole& pole : groups[g].fit.poles)
      if (is_within(pole, of_other)) subtract(pole, response);
  }
  return response;
}

}  // namespace scree::signals
