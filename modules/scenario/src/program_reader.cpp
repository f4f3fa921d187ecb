#include "readers.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include <scree/plugin/program.hpp>

namespace scree::scenario {

namespace {

// Each of these keys selects another kind of function.
void refuse_mixture(const document::Table& t) {
  std::vector<std::string> given;
  for (const char* key : {"table", "amplitude", "period", "duration"})
    if (t.has(key)) given.push_back(key);
  if (given.size() > 1)
    throw t.error(given[1],
                  fmt::format("'{}' and '{}' belong to different functions of time", given[0], given[1]),
                  "keep one: period (there and back, again and again), duration (once from 'from' to 'to'), "
                  "amplitude (a sine), or table");
}

std::vector<double> read_rows(const document::Table& t) {
  std::vector<double> data = {Program::table};
  double last = -std::numeric_limits<double>::infinity();
  for (const auto& row : t.rows("table", 2)) {
    if (row[0] <= last)
      throw t.error("table", "the times do not increase", "sort the rows, with every time only once");
    last = row[0];
    data.insert(data.end(), row.begin(), row.end());
  }
  if (data.size() == 1) throw t.error("table", "'table' has no rows", "give [[time, value], ...]");
  return data;
}

constexpr std::size_t most_sines = 100000;

double frequency(const document::Table& t, const char* key) {
  return t.number(key, document::Range::positive("Hz"));
}

// Frequencies from one to another, each for a number of whole periods, so that the motion is continuous.
std::vector<double> read_sweep(const document::Table& t, double mean, double amplitude, double rise) {
  const double from = frequency(t, "from_hz"), to = frequency(t, "to_hz"), spacing = frequency(t, "step_hz");
  const double periods = t.number("periods", document::Range::at_least(1));
  if (periods != std::floor(periods))
    throw t.error("periods", fmt::format("{:g} periods are not a whole number", periods),
                  "give a whole number");
  const double steps = std::floor(std::abs(to - from) / spacing * (1 + 1e-12)) + 1;
  if (steps > double(most_sines))
    throw t.error("step_hz", fmt::format("{:g} frequencies are more than {}", steps, most_sines),
                  "give a larger step_hz");
  std::vector<double> data = {Program::sweep, mean, amplitude, rise, 0};
  double time = 0;
  for (double k = 0; k < steps; ++k) {
    const double now = from + (to < from ? -k : k) * spacing;
    data.insert(data.end(), {now, time});
    time += periods / now;
  }
  data[4] = time;
  return data;
}

// Sines of random phases at equal distances, of the given root mean square together.
std::vector<double> read_noise(const document::Table& t, double mean, double rise) {
  const double low = frequency(t, "low_hz"), high = frequency(t, "high_hz");
  if (!(high > low)) throw t.error("high_hz", "the band is empty", "give a high_hz above low_hz");
  const auto sines = std::size_t(t.integer("sines", 256, document::Range::between(1, most_sines)));
  packing::Random random(std::uint64_t(t.integer("seed", 1, document::Range::non_negative())));
  const double spacing = (high - low) / double(sines), rms = t.number("rms");
  std::vector<double> data = {Program::noise,      mean,   rms * std::sqrt(2 / double(sines)), rise,
                              low + 0.5 * spacing, spacing};
  for (std::size_t k = 0; k < sines; ++k) data.push_back(2 * std::numbers::pi * random.uniform());
  return data;
}

std::vector<double> read_wave(const document::Table& t) {
  const std::string wave = t.choice("wave", {"sine", "chirp", "sweep", "gaussian", "ricker", "noise"});
  const double mean = t.number("mean", 0.0);
  const bool pulse = wave == "gaussian" || wave == "ricker";
  const double rise = pulse ? 0 : t.number("rise", 0.0, document::Range::non_negative("s"));
  if (wave == "noise") return read_noise(t, mean, rise);
  const double amplitude = t.number("amplitude");
  if (wave == "sweep") return read_sweep(t, mean, amplitude, rise);
  if (wave == "sine")
    return {Program::drive,
            mean,
            amplitude,
            rise,
            frequency(t, "frequency_hz"),
            t.number("phase_deg", 0.0) * std::numbers::pi / 180};
  if (wave == "chirp")
    return {Program::chirp,
            mean,
            amplitude,
            rise,
            frequency(t, "from_hz"),
            frequency(t, "to_hz"),
            t.number("duration", document::Range::positive("s")),
            t.boolean("logarithmic", false) ? 1.0 : 0.0};
  const double at = t.number("at", document::Range::non_negative("s"));
  if (wave == "gaussian")
    return {Program::gaussian, mean, amplitude, at, t.number("width", document::Range::positive("s"))};
  return {Program::ricker, mean, amplitude, at, frequency(t, "frequency_hz")};
}

}  // namespace

std::vector<double> read_program(const document::Table& table, const std::string& key) {
  if (!table.is_table(key)) return {Program::constant, table.number(key)};
  return read_program_of(table.table(key), key);
}

std::vector<double> read_program_of(const document::Table& t, const std::string& key) {
  if (t.optional("wave")) return read_wave(t);
  refuse_mixture(t);
  if (t.optional("table")) return read_rows(t);
  if (t.optional("amplitude"))
    return {Program::sine, t.number("mean", 0.0), t.number("amplitude"),
            t.number("frequency_hz", document::Range::positive("Hz")),
            t.number("phase_deg", 0.0) * std::numbers::pi / 180};
  if (t.optional("period"))
    return {Program::cycle, t.number("from"), t.number("to"),
            t.number("period", document::Range::positive("s"))};
  if (t.optional("duration"))
    return {Program::ramp, t.number("from"), t.number("to"),
            t.number("duration", document::Range::positive("s"))};
  throw t.error(fmt::format("'{}' is not a function of time", key),
                "give a number, {from, to, period}, {from, to, duration}, {mean, amplitude, frequency_hz}, "
                "{table = [[t, value], ...]} or {wave = \"chirp\", ...}");
}

}  // namespace scree::scenario
