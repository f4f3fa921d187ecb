#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include <scree/modes/density.hpp>
#include <scree/threads.hpp>

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
    (system.count_below(square(middle)) < system.modes() ? low : high) = middle;
  }
  return high;
}

// Counts below each frequency, on several threads; nothing where it was ended.
std::vector<std::optional<std::size_t>> counts_below(const response::UndampedSystem& system,
                                                     const std::vector<double>& frequencies,
                                                     const DensityOptions& options) {
  std::vector<std::optional<std::size_t>> counts(frequencies.size());
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t k; (k = next++) < frequencies.size() && options.proceed();) try {
        counts[k] = system.count_below(square(frequencies[k]));
        const std::lock_guard lock(mutex);
        options.on_progress(double(halvings + ++done) / double(halvings + frequencies.size()),
                            "density of states");
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        next = frequencies.size();
      }
  };
  on_threads(options.threads, work);
  if (failure) std::rethrow_exception(failure);
  return counts;
}

}  // namespace

std::vector<DensityPoint> density_of_states(const response::UndampedSystem& system, std::size_t bodies,
                                            const DensityOptions& options) {
  const int dimension = system.system().freedom.dimension();
  const std::size_t resting = system.count_below(system.rounding());
  const double highest = options.to_hz > 0 ? options.to_hz : highest_frequency(system, options);
  const double step = highest / options.points;
  std::vector<double> frequencies;
  for (unsigned k = 1; k <= options.points; ++k) frequencies.push_back(k * step);
  const auto counts = counts_below(system, frequencies, options);
  std::vector<DensityPoint> points;
  std::size_t before = 0;
  for (std::size_t k = 0; k < counts.size() && counts[k]; ++k) {
    // At frequencies of floppy modes round-off decides how many of them are counted.
    const std::size_t below = std::max(*counts[k], resting + before) - resting, modes = below - before;
    const double from = double(k) * step, middle = from + 0.5 * step;
    const double density = double(modes) / step / double(bodies);
    points.push_back(
        {from, frequencies[k], modes, below, density, density / std::pow(middle, dimension - 1)});
    before = below;
  }
  return points;
}

}  // namespace scree::modes
