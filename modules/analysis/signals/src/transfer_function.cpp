#include "scree/signals/transfer_function.hpp"

#include "fourier.hpp"
#include "scree/signals/amplitude_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::signals {

namespace {

using Complex = std::complex<double>;

// Sums over segments.
struct CrossSpectra {
  std::vector<double> xx, yy;
  std::vector<Complex> xy;
  explicit CrossSpectra(std::size_t count) : xx(count), yy(count), xy(count) {}
};

void check(std::span<const double> times, std::span<const double> drive, std::span<const double> response,
           std::size_t segment) {
  constexpr std::size_t least = 4;
  constexpr double tolerated = 1e-3;
  const std::size_t count = times.size();
  if (drive.size() != count || response.size() != count)
    throw Error(
        fmt::format("transfer function: {} times, {} values of the drive and {} of the response; give as "
                    "many of each",
                    count, drive.size(), response.size()));
  if (count < std::max(least, segment) || (segment > 0 && segment < least))
    throw Error(
        fmt::format("transfer function: {} samples in segments of {}; give at least {} in a segment and "
                    "one segment",
                    count, segment, least));
  if (const double differ = unevenness(times); differ > tolerated)
    throw Error(fmt::format(
        "transfer function: samples are up to {:.3g} steps away from equal steps; put the records "
        "on equal steps first",
        differ));
}

void load(std::span<double> to, std::span<const double> from, const std::vector<double>& window) {
  std::copy(from.begin(), from.end(), to.begin());
  if (window.empty()) return;
  const double mean = std::accumulate(from.begin(), from.end(), 0.0) / double(from.size());
  for (std::size_t j = 0; j < to.size(); ++j) to[j] = window[j] * (to[j] - mean);
}

double independent_segments(std::size_t count, std::size_t hop, const std::vector<double>& window) {
  const double square = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
  double sum = 1;
  for (std::size_t j = 1; j < count && j * hop < window.size(); ++j) {
    const auto shifted = window.begin() + std::ptrdiff_t(j * hop);
    const double correlation = std::inner_product(shifted, window.end(), window.begin(), 0.0) / square;
    sum += 2 * (1 - double(j) / double(count)) * correlation * correlation;
  }
  return double(count) / sum;
}

void add_segment(CrossSpectra& sums, Fourier& fourier, std::span<const double> drive,
                 std::span<const double> response, const std::vector<double>& window) {
  load(fourier.values(), drive, window);
  const std::span<const Complex> first = fourier.transform();
  const std::vector<Complex> x(first.begin(), first.end());
  load(fourier.values(), response, window);
  const std::span<const Complex> y = fourier.transform();
  for (std::size_t k = 0; k < x.size(); ++k) {
    sums.xx[k] += std::norm(x[k]);
    sums.yy[k] += std::norm(y[k]);
    sums.xy[k] += std::conj(x[k]) * y[k];
  }
}

void add_entry(TransferFunction& transfer, double xx, double yy, Complex xy) {
  const bool driven = xx > 0, answered = std::norm(xy) > 0;
  transfer.h1.push_back(driven ? xy / xx : 0);
  transfer.h2.push_back(answered ? yy / std::conj(xy) : 0);
  const double coherence = answered ? std::min(1.0, std::norm(xy) / (xx * yy)) : 0;
  transfer.coherence.push_back(coherence);
  if (transfer.segments == 1 && coherence > 0)
    transfer.error.push_back(std::numeric_limits<double>::quiet_NaN());
  else
    transfer.error.push_back(std::sqrt((1 - coherence) / (2 * coherence * transfer.averages)));
}

}  // namespace

TransferFunction transfer_function(std::span<const double> times, std::span<const double> drive,
                                   std::span<const double> response, std::size_t segment) {
  check(times, drive, response, segment);
  const std::size_t count = times.size(), length = segment > 0 ? segment : count;
  const std::vector<double> window = segment > 0 ? hann(length) : std::vector<double>();
  const std::size_t hop = std::max<std::size_t>(1, length / 2);
  CrossSpectra sums(length / 2 + 1);
  Fourier fourier(length);
  TransferFunction transfer;
  for (std::size_t first = 0; first + length <= count; first += hop, ++transfer.segments)
    add_segment(sums, fourier, drive.subspan(first, length), response.subspan(first, length), window);
  transfer.averages = segment > 0 ? independent_segments(transfer.segments, hop, window) : 1;
  transfer.resolution = double(count - 1) / (times.back() - times.front()) / double(length);
  for (std::size_t k = 0; k < sums.xx.size(); ++k) add_entry(transfer, sums.xx[k], sums.yy[k], sums.xy[k]);
  return transfer;
}

}  // namespace scree::signals
