#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include <scree/modes/density.hpp>
#include <scree/thread_pool.hpp>

namespace scree::modes {

namespace {

constexpr int halvings = 6;  // of the interval in which the highest frequency is

double square(double frequency_hz) {
  const double omega = 2 * std::numbers::pi * frequency_hz;
  return omega * omega;
}

// A frequency above all modes, within 2 % of a bound.
double highest_frequency(const response::UndampedSystem& system, const DensityOptions& options) {
  double low = 0, high = std::sqrt(system.largest()) / (2 * std::numbers::pi) * (1 + 1e-9);
  for (int k = 0; k < halvings && options.proceed(); ++k) {
    options.on_progress(double(k) / (halvings + options.points), "highest frequency");
    const double middle = 0.5 * (low + high);
    (system.count_below(square(middle)).modes < system.modes() ? low : high) = middle;
  }
  return high;
}

// Counts below each frequency, on several threads; nothing where it was ended.
std::vector<std::optional<response::ModeCount>> counts_below(const response::UndampedSystem& system,
                                                             const std::vector<double>& frequencies,
                                                             const DensityOptions& options) {
  std::vector<std::optional<response::ModeCount>> counts(frequencies.size());
  std::size_t done = 0;
  std::mutex mutex;
  ThreadPool pool(options.threads, ThreadPool::IfTooFew::use_fewer);
  pool.each_in_order(frequencies.size(), [&](std::size_t k, unsigned) {
    if (!options.proceed()) return;
    counts[k] = system.count_below(square(frequencies[k]));
    const std::lock_guard lock(mutex);
    options.on_progress(double(halvings + ++done) / double(halvings + frequencies.size()),
                        "density of states");
  });
  return counts;
}

}  // namespace

std::vector<DensityPoint> density_of_states(const response::UndampedSystem& system, std::size_t bodies,
                                            const DensityOptions& options) {
  const int dimension = system.system().freedom.dimension();
  const response::ModeCount resting = system.count_below(system.rounding());
  const double highest = options.to_hz > 0 ? options.to_hz : highest_frequency(system, options);
  const double step = highest / options.points;
  std::vector<double> frequencies;
  for (unsigned k = 1; k <= options.points; ++k) frequencies.push_back(k * step);
  const auto counts = counts_below(system, frequencies, options);
  std::vector<DensityPoint> points;
  std::size_t before = 0;
  for (std::size_t k = 0; k < counts.size() && counts[k]; ++k) {
    // At frequencies of floppy modes round-off decides how many of them are counted.
    const std::size_t below = std::max(counts[k]->modes, resting.modes + before) - resting.modes,
                      modes = below - before;
    const double from = double(k) * step, middle = from + 0.5 * step;
    const double density = double(modes) / step / double(bodies);
    points.push_back({from, frequencies[k], modes, below, density, density / std::pow(middle, dimension - 1),
                      counts[k]->certain && resting.certain});
    before = below;
  }
  return points;
}

}  // namespace scree::modes
