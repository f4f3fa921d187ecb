#include "body_stress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

namespace scree::pictures {

namespace {

double volume_of(const Frame& frame, std::size_t body) {
  const double r = frame.radius[body];
  return frame.dimension == 2 ? std::numbers::pi * r * r : 4.0 / 3.0 * std::numbers::pi * r * r * r;
}

// Calls use(body, contact) for both bodies of each contact; false if the frame does not say which they are.
template <class Use>
bool for_each_end(const Frame& frame, const Use& use) {
  if (frame.contact_a.size() != frame.contact_count()) return false;
  std::unordered_map<std::int64_t, std::size_t> bodies;
  for (std::size_t i = 0; i < frame.particle_count(); ++i) bodies[frame.id[i]] = i;
  for (std::size_t c = 0; c < frame.contact_count(); ++c)
    for (const std::int64_t id : {frame.contact_a[c], frame.contact_b[c]})
      if (const auto found = bodies.find(id); found != bodies.end()) use(found->second, c);
  return true;
}

}  // namespace

std::vector<double> largest_forces(const Frame& frame) {
  std::vector<double> largest(frame.particle_count(), 0.0);
  const bool known = for_each_end(frame, [&](std::size_t body, std::size_t c) {
    const double* const f = frame.contact_force.data() + 3 * c;
    largest[body] = std::max(largest[body], std::hypot(f[0], f[1], f[2]));
  });
  return known ? largest : std::vector<double>();
}

std::vector<double> pressures(const Frame& frame) {
  std::vector<double> pressure(frame.particle_count(), 0.0);
  const bool known = for_each_end(frame, [&](std::size_t body, std::size_t c) {
    pressure[body] += frame.contact_normal_force[c] * (frame.radius[body] - 0.5 * frame.contact_overlap[c]) /
                      (double(frame.dimension) * volume_of(frame, body));
  });
  return known ? pressure : std::vector<double>();
}

std::vector<double> stresses(const Frame& frame) {
  std::vector<double> stress(6 * frame.particle_count(), 0.0);
  const bool known = for_each_end(frame, [&](std::size_t body, std::size_t c) {
    const double arm = (frame.radius[body] - 0.5 * frame.contact_overlap[c]) / volume_of(frame, body);
    const double* const f = frame.contact_force.data() + 3 * c;
    const double* const n = frame.contact_normal.data() + 3 * c;
    double* const s = stress.data() + 6 * body;
    // Force and arm change their signs together at the other end of the contact.
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      s[k] += arm * f[k] * n[k];
      s[3 + k] += 0.5 * arm * (f[k] * n[next] + f[next] * n[k]);
    }
  });
  return known ? stress : std::vector<double>();
}

}  // namespace scree::pictures
