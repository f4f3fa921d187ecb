#include "motion/motion.hpp"

#include "machine/instruction_levels.hpp"

#include <algorithm>

namespace scree {

using namespace kernel;

namespace {

// Updates the largest |v|² over records, of the components for which `axes` is 1; each of the four lanes
// covers a fourth of the bodies. A square that is not finite is kept in `unbounded`.
SCREE_EVERY_LEVEL void update_largest_square(Four& largest, Four& unbounded, const double* first,
                                             std::size_t stride, std::size_t count, const Four& axes) {
  for (std::size_t i = 0; i < count; i += 4) {
    Four v[4];
    // Past the end the last body is used again.
    for (std::size_t k = 0; k < 4; ++k) v[k] = axes * load_four(first + stride * std::min(i + k, count - 1));
    transpose(v[0], v[1], v[2], v[3]);
    const Four square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    largest = square > largest ? square : largest;
    unbounded = square < infinite_speed ? unbounded : square;
  }
}

}  // namespace

double Motions::largest_square(BodyRange bodies, bool mid_step) const {
  const std::size_t count = bodies.end - bodies.begin;
  if (count == 0) return 0;
  Four largest = {}, unbounded = {};
  update_largest_square(largest, unbounded, part(bodies, mid_step ? record::mid_motion : record::motion),
                        width(), count, axes());
  double maximum = 0;
  for (int k = 0; k < 4; ++k) {
    if (!(unbounded[k] == 0)) return infinite_speed;
    maximum = std::max(maximum, largest[k]);
  }
  return maximum;
}

}  // namespace scree
