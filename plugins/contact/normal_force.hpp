// Force along the normal, of a spring and a dashpot in parallel.

#pragma once

#include <algorithm>

#include <scree/plugin/contact.hpp>
#include <scree/plugin/restitution.hpp>

namespace normal {

template <class T>
struct Force {
  T spring;     // (N)
  T total;      // spring and dashpot; not below 0 if tension is cut (N)
  T repulsive;  // the same, not below 0 in any case: it limits friction (N)
};

// Sets the dissipated power of the dashpot. total: of spring and dashpot (N).
template <int D, class T, bool couple>
Force<T> with_tension(scree::Tension tension, const T& spring, const T& total, const T& v_n,
                      scree::LawOutput<D, T, couple>& out) {
  const T repulsive = std::max(total, T(0));
  const T f_n = tension == scree::Tension::cut ? repulsive : total;
  out.dissipation_rate_normal = (spring - f_n) * v_n;
  return {spring, f_n, repulsive};
}

}  // namespace normal
