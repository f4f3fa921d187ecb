#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <scree/domain.hpp>

namespace scree {

// Folds differences to the nearest image, prepared for many of them; without branches.
class Folding {
 public:
  explicit Folding(const Domain& domain) {
    for (int k = 0; k < 3; ++k)
      if (domain.periodic[k]) {
        length_[k] = period_[k] = domain.length(k);
        half_[k] = 0.5 * domain.length(k);
      }
  }

  // Makes a − b that of the nearest image of b, for coordinates within the domain, and tells which it is: one
  // of −1, 0, 1 per axis as a base-3 code with 13 for none.
  int fold(Vec3& a_minus_b) const {
    int code = Domain::no_shift;
    for (int k = 0, weight = 1; k < 3; ++k, weight *= 3) {
      const int turns = int(a_minus_b[k] < -half_[k]) - int(a_minus_b[k] > half_[k]);
      a_minus_b[k] += turns * length_[k];
      code += turns * weight;
    }
    return code;
  }
  // |a − b|² of the nearest image alone.
  double square_distance(Vec3 a_minus_b) const {
    for (int k = 0; k < 3; ++k) {
      const double apart = std::abs(a_minus_b[k]);
      a_minus_b[k] = std::min(apart, period_[k] - apart);
    }
    return square(a_minus_b);
  }
  static double square(const Vec3& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr Vec3 nowhere = {{infinite, infinite, infinite}};
  Vec3 length_ = {}, half_ = nowhere, period_ = nowhere;  // of axes that are not periodic 0, infinite
};

}  // namespace scree
