#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/spectrum/method_spectrum.hpp>

namespace scree::spectrum {

namespace {

void transfer_column(const StateTransfer& state, std::size_t frequencies, MethodSpectrum::Column& column) {
  std::vector<double> parts;
  for (const std::complex<double>& h : column.response) parts.insert(parts.end(), {h.real(), h.imag()});
  if (state.restoring()) parts.resize(2 * frequencies), column.error.resize(frequencies);
  state.sized_rows("response", "1", parts, 1, stored::any);
  column.response.resize(parts.size() / 2);
  for (std::size_t k = 0; k < column.response.size(); ++k)
    column.response[k] = {parts[2 * k], parts[2 * k + 1]};
  state.sized_rows("error", "1", column.error, 1, stored::any);
  state.rows("linearity", "1", column.linearity, 1, stored::any);
  if (!column.linearity.empty() && column.linearity.size() != frequencies)
    state.refuse("linearity", "does not have a number for each frequency");
}

}  // namespace

std::size_t MethodSpectrum::nearest(double frequency) const {
  const auto next = std::min_element(frequencies.begin(), frequencies.end(), [&](double a, double b) {
    return std::abs(a - frequency) < std::abs(b - frequency);
  });
  return std::size_t(next - frequencies.begin());
}

void MethodSpectrum::note_silent(const std::vector<ObservedColumn>& observed) {
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto& response = columns[c].response;
    const bool silent =
        !response.empty() && std::none_of(response.begin(), response.end(),
                                          [](const std::complex<double>& h) { return std::abs(h) > 0; });
    if (silent && !observed[c].of_shape)
      notes.push_back(fmt::format(
          "{}: the wave does not reach {}, which is 0 at all frequencies; compress the packing, observe another column, "
          "or give a larger spectrum.amplitude",
          method, observed[c].name));
  }
}

void MethodSpectrum::transfer(const StateTransfer& state, std::size_t observed) {
  state.value("method", "", method);
  state.rows("frequencies", "1/s", frequencies, 1, stored::positive);
  if (!std::is_sorted(frequencies.begin(), frequencies.end())) state.refuse("frequencies", "do not increase");
  state.value("steps", "1", steps);
  state.value("wall", "s", wall_time, stored::non_negative);
  state.rows("notes", "", notes);
  std::uint64_t count = columns.size();
  state.value("columns", "1", count, stored::at_most(observed));
  if (count < observed && !frequencies.empty() && state.restoring())
    state.refuse("columns", fmt::format("is {}, and the scenario observes {}", count, observed));
  columns.resize(count);
  for (std::size_t c = 0; c < columns.size(); ++c)
    transfer_column(state.below(std::to_string(c)), frequencies.size(), columns[c]);
}

}  // namespace scree::spectrum
