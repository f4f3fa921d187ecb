#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/domain.hpp>

namespace scree {

// Branch-free minimum-image convention for a periodic domain.
class Folding {
 public:
  explicit Folding(const Domain& domain) {
    for (int k = 0; k < 3; ++k)
      if (domain.periodic[k]) {
        length_[k] = period_[k] = domain.length(k);
        half_[k] = 0.5 * domain.length(k);
      }
  }

  // Replaces a − b by its value for the nearest image of b, for coordinates within the domain. Returns the
  // image: −1, 0 or 1 per axis as a base-3 code, in which 13 means no shift.
  int fold(Vec3& a_minus_b) const {
    int code = Domain::no_shift;
    for (int k = 0, weight = 1; k < 3; ++k, weight *= 3) {
      const int turns = int(a_minus_b[k] < -half_[k]) - int(a_minus_b[k] > half_[k]);
      a_minus_b[k] += turns * length_[k];
      code += turns * weight;
    }
    return code;
  }
  // |a − b|² for the nearest image (m²).
  double square_distance(Vec3 a_minus_b) const {
    for (int k = 0; k < 3; ++k) {
      const double separation = std::abs(a_minus_b[k]);
      a_minus_b[k] = std::min(separation, period_[k] - separation);
    }
    return square(a_minus_b);
  }
  static double square(const Vec3& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr Vec3 unbounded = {{infinite, infinite, infinite}};
  Vec3 length_ = {}, half_ = unbounded, period_ = unbounded;  // axes that are not periodic: 0, infinite
};

}  // namespace scree
