#pragma once

#include <cstddef>
#include <cstdint>

#include <scree/plugin/averaging_frame.hpp>
#include <scree/plugin/probe.hpp>

namespace scree {

// Sums over the bodies of each bin, which a probe has among its totals: `width` numbers for each bin in turn.
class BinMotion {
 public:
  static constexpr std::uint32_t width = 8;
  struct Sums {
    double bodies = 0, mass = 0;  // number, (kg)
    Vec3 momentum = {};           // (kg m/s)
    Vec3 spin = {};               // (rad/s)
    // Means: by mass and by number; NaN without bodies.
    Vec3 velocity() const { return 1 / mass * momentum; }
    Vec3 mean_spin() const { return 1 / bodies * spin; }
  };

  // totals: of all parts, from the first bin on.
  explicit BinMotion(const double* totals) : totals_(totals) {}

  Sums operator[](std::size_t bin) const {
    const double* const t = totals_ + bin * width;
    return {t[0], t[1], {{t[2], t[3], t[4]}}, {{t[5], t[6], t[7]}}};
  }

  // Adds the bodies of a part to its totals, from the first bin on.
  static void add(const scree_view& part, const AveragingFrame& frame, double* totals) {
    each_counted(part, frame, [&](std::uint64_t i, std::size_t bin) {
      double* const t = totals + bin * width;
      const Vec3 momentum = part.mass[i] * vector_of(part.velocity, i), spin = vector_of(part.spin, i);
      t[0] += 1;
      t[1] += part.mass[i];
      for (int k = 0; k < 3; ++k) {
        t[2 + k] += momentum[k];
        t[5 + k] += spin[k];
      }
    });
  }

  // Calls visit(body, bin, velocity about the mean of the bin, spin about it) for the bodies of a part.
  template <class Visit>
  void each_body(const scree_view& part, const AveragingFrame& frame, const Visit& visit) const {
    each_counted(part, frame, [&](std::uint64_t i, std::size_t bin) {
      const Sums sums = (*this)[bin];
      visit(i, bin, vector_of(part.velocity, i) - sums.velocity(),
            vector_of(part.spin, i) - sums.mean_spin());
    });
  }

 private:
  template <class Visit>
  static void each_counted(const scree_view& part, const AveragingFrame& frame, const Visit& visit) {
    for (std::uint64_t i = part.part_begin; i < part.part_end; ++i) {
      if (!counts(part, i)) continue;
      const int bin = frame.bin_of(vector_of(part.position, i));
      if (bin >= 0) visit(i, std::size_t(bin));
    }
  }

  const double* totals_;
};

}  // namespace scree
