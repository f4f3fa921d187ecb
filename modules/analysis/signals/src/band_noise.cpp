#include "scree/signals/band_noise.hpp"

#include "fourier.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::signals {

std::vector<double> band_noise(std::size_t count, std::size_t first, std::size_t last,
                               const std::function<double()>& normal) {
  if (first == 0 || last < first || 2 * last >= count)
    throw Error(
        fmt::format("noise: no band from {} to {} in {} values; give 1 or more, and less than half of them",
                    first, last, count));
  Fourier fourier(count);
  const std::span<double> parts = fourier.values();
  std::fill(parts.begin(), parts.end(), 0.0);
  // Re - Im of the transform is (a + b) cos + (a - b) sin for the entries a at k and b at count - k, whose
  // coefficients are independent.
  for (std::size_t k = first; k <= last; ++k) parts[k] = normal(), parts[count - k] = normal();
  const double scale = 1 / std::sqrt(2 * double(last - first + 1));
  std::vector<double> noise(count);
  const auto transform = fourier.transform();
  for (std::size_t j = 0; j < transform.size(); ++j) {
    noise[j] = scale * (transform[j].real() - transform[j].imag());
    if (j > 0) noise[count - j] = scale * (transform[j].real() + transform[j].imag());
  }
  return noise;
}

}  // namespace scree::signals
