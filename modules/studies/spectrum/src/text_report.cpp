#include "measurement_files.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>

namespace scree::spectrum {

namespace {

constexpr std::size_t most_lines = 25;

// A peak of the first method that has any, and the nearest of each other method.
std::string peak_line(const Measurement& m, const Peak& first) {
  std::string line = fmt::format("{:>12.6g} ± {:<8.2g} {:>10.4g}", first.mode.frequency,
                                 first.mode.frequency_error, first.mode.quality);
  for (std::size_t r = first.spectrum + 1; r < m.spectra.size(); ++r) {
    const Peak* nearest = nullptr;
    for (const Peak& other : m.peaks)
      if (other.spectrum == r && other.column == first.column &&
          (!nearest || std::abs(other.mode.frequency - first.mode.frequency) <
                           std::abs(nearest->mode.frequency - first.mode.frequency)))
        nearest = &other;
    line += nearest ? fmt::format("  {:>+10.3g} ± {:<8.2g}", nearest->mode.frequency - first.mode.frequency,
                                  nearest->mode.frequency_error)
                    : fmt::format("  {:>21}", "-");
  }
  if (const std::string name = name_of(first); !name.empty()) line += "  " + name;
  return line;
}

void add_peaks(const Measurement& m, std::size_t column, std::vector<std::string>& lines) {
  const auto first =
      std::find_if(m.peaks.begin(), m.peaks.end(), [&](const Peak& r) { return r.column == column; });
  if (first == m.peaks.end()) {
    const bool sought = std::any_of(m.spectra.begin(), m.spectra.end(), [](const MethodSpectrum& spectrum) {
      return spectrum.frequencies.size() >= fewest_frequencies_of_peaks;
    });
    const std::string why = sought || m.interrupted
                                ? ""
                                : fmt::format(", which need {} frequencies or more; give a smaller step_hz",
                                              fewest_frequencies_of_peaks);
    lines.push_back(fmt::format("{}: no peaks{}{}", files::one_line(m.observed[column].name),
                                m.interrupted ? " yet" : "", why));
    return;
  }
  std::string head = fmt::format("{}, {}: {:>6} {:>10}", files::one_line(m.observed[column].name),
                                 m.spectra[first->spectrum].method, "f0 [Hz]", "Q");
  for (std::size_t r = first->spectrum + 1; r < m.spectra.size(); ++r)
    head += fmt::format("  {:>21}", m.spectra[r].method + " − [Hz]");
  lines.push_back(head);
  for (auto r = first; r != m.peaks.end() && r->column == column && r->spectrum == first->spectrum; ++r)
    lines.push_back(peak_line(m, *r));
}

}  // namespace

std::string text_report(const Measurement& m) {
  std::vector<std::string> lines;
  lines.push_back(fmt::format("{:<12} {:>12} {:>12} {:>12}", "method", "frequencies", "steps", "wall [s]"));
  for (const MethodSpectrum& spectrum : m.spectra)
    lines.push_back(fmt::format("{:<12} {:>12} {:>12} {:>12.4g}", spectrum.method,
                                spectrum.frequencies.size(), spectrum.steps, spectrum.wall_time));
  for (std::size_t c = 0; c < responding(m.observed); ++c) add_peaks(m, c, lines);
  std::string text;
  const bool all = lines.size() <= most_lines;
  for (std::size_t k = 0; k < (all ? lines.size() : most_lines - 1); ++k) text += lines[k] + "\n";
  if (!all)
    text +=
        fmt::format("... {} of peaks in peaks.csv\n", counted(lines.size() - most_lines + 1, "more line"));
  return text;
}

}  // namespace scree::spectrum
