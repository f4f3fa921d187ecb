#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <scree/plugin/averaging_frame.hpp>
#include <scree/plugin/probe.hpp>

namespace scree {

// Sums over the bodies of each bin, and the bin of each body: −1 outside and for bodies that the probe does
// not count.
struct BinMotion {
  struct Sums {
    double bodies = 0, mass = 0;  // number, (kg)
    Vec3 momentum = {};           // (kg m/s)
    Vec3 spin = {};               // (rad/s)
    // Means: by mass and by number; NaN without bodies.
    Vec3 velocity() const { return 1 / mass * momentum; }
    Vec3 mean_spin() const { return 1 / bodies * spin; }
  };
  std::vector<Sums> bins;
  std::vector<int> bin_of;

  BinMotion(const scree_view& view, const AveragingFrame& frame)
      : bins(std::size_t(frame.bins)), bin_of(view.body_count, -1) {
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      if (!counts(view, i)) continue;
      bin_of[i] = frame.bin_of(vector_of(view.position, i));
      if (bin_of[i] < 0) continue;
      Sums& bin = bins[std::size_t(bin_of[i])];
      bin.bodies += 1;
      bin.mass += view.mass[i];
      bin.momentum += view.mass[i] * vector_of(view.velocity, i);
      bin.spin += vector_of(view.spin, i);
    }
  }

  // Calls visit(body, bin, velocity about the mean of the bin, spin about it).
  template <class Visit>
  void each_body(const scree_view& view, const Visit& visit) const {
    for (std::uint64_t i = 0; i < view.body_count; ++i) {
      if (bin_of[i] < 0) continue;
      const Sums& bin = bins[std::size_t(bin_of[i])];
      visit(i, std::size_t(bin_of[i]), vector_of(view.velocity, i) - bin.velocity(),
            vector_of(view.spin, i) - bin.mean_spin());
    }
  }
};

}  // namespace scree
