#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <scree/forces.hpp>

namespace scree::kernel {

// Contacts a law is given in one call.
inline constexpr std::uint32_t block_size = 256;

// Doubles that a pair leaves for the sum over bodies: force on a, torque on a, torque on b.
template <int D, bool spin>
inline constexpr int record_width = D + (spin ? 2 * spin_components<D> : 0);

// Columns of one block, reused for every block of a thread. T is what laws compute in, double or float.
template <class T>
struct alignas(64) Buffers {
  T input[SCREE_CONTACT_INPUT_COUNT][block_size];
  T output[SCREE_CONTACT_OUTPUT_COUNT][block_size];
  double arm_a[block_size], arm_b[block_size], overlap_ratio[block_size];
};

// What every block of an evaluation shares.
struct Scene {
  const Particles& particles;
  const Contacts& contacts;
  const scree_plane* planes;
  const Vec3* shifts;  // of each image code
  double step;
  bool audit;
};

template <int D>
Vec<D> load(const Column<double> (&columns)[3], std::size_t i) {
  Vec<D> v;
  for (int k = 0; k < D; ++k) v[k] = columns[k][i];
  return v;
}

template <int D>
Vec<spin_components<D>> load_spin(const Column<double> (&columns)[3], std::size_t i) {
  if constexpr (D == 2)
    return {{columns[2][i]}};
  else
    return load<3>(columns, i);
}

template <int N, class T>
void store(T (*columns)[block_size], std::uint32_t lane, const Vec<N>& v) {
  for (int k = 0; k < N; ++k) columns[k][lane] = T(v[k]);
}

// Body b of a pair, or the plane in its place: everything that the relative motion needs.
template <int D, bool spin>
struct Partner {
  Vec<D> separation;  // x_a − x_b, or the normal distance to the plane
  double radius, inverse_radius, inverse_mass;
  Vec<D> velocity, mid_velocity;
  Vec<spin_components<D>> spin_now, mid_spin;
};

template <int D, bool spin>
[[gnu::always_inline]] inline Partner<D, spin> body_partner(const Scene& s, std::uint32_t a, std::uint32_t b,
                                                            std::uint8_t image) {
  const Particles& p = s.particles;
  Partner<D, spin> partner{};
  partner.separation = load<D>(p.position, a) - load<D>(p.position, b);
  for (int k = 0; k < D; ++k) partner.separation[k] += s.shifts[image][k];
  partner.radius = p.radius[b];
  partner.inverse_radius = 1 / p.radius[b];
  partner.inverse_mass = p.inverse_mass[b];
  partner.velocity = load<D>(p.velocity, b);
  partner.mid_velocity = load<D>(p.mid_velocity, b);
  if constexpr (spin)
    partner.spin_now = load_spin<D>(p.spin, b), partner.mid_spin = load_spin<D>(p.mid_spin, b);
  return partner;
}

// A plane is a body of infinite radius and mass that does not turn.
template <int D, bool spin>
Partner<D, spin> plane_partner(const Scene& s, std::uint32_t a, std::uint32_t b) {
  const scree_plane& plane = s.planes[b];
  Partner<D, spin> partner{};
  double distance = 0;
  const Vec<D> x = load<D>(s.particles.position, a);
  for (int k = 0; k < D; ++k) distance += (x[k] - plane.point[k]) * plane.normal[k];
  for (int k = 0; k < D; ++k) {
    partner.separation[k] = distance * plane.normal[k];
    partner.velocity[k] = plane.velocity[k];
    partner.mid_velocity[k] = plane.mid_velocity[k];
  }
  return partner;
}

// Unit vector along d, or along x where the centres coincide.
template <int D>
Vec<D> direction(const Vec<D>& d, double length) {
  Vec<D> n = (length > 0 ? 1 / length : 0.0) * d;
  n[0] = length > 0 ? n[0] : 1.0;
  return n;
}

template <int D>
double plane_side(const scree_plane& plane, const Vec<D>& separation) {
  double side = 0;
  for (int k = 0; k < D; ++k) side += separation[k] * plane.normal[k];
  return side;
}

// Normal and distance; behind a plane the distance is negative and the normal stays the plane's.
template <int D, bool planes>
[[gnu::always_inline]] inline double resolve(const Scene& s, std::uint32_t b, const Vec<D>& separation,
                                             Vec<D>& normal) {
  if constexpr (planes) {
    for (int k = 0; k < D; ++k) normal[k] = s.planes[b].normal[k];
    return plane_side<D>(s.planes[b], separation);
  } else {
    const double distance = norm(separation);
    normal = direction(separation, distance);
    return distance;
  }
}

struct Arms {
  double a, b;
};

// Lever arms from the centres to the contact point; a plane has none.
template <bool planes>
Arms arms_of(std::uint32_t convention, double radius_a, double radius_b, double overlap) {
  const double half = convention == SCREE_ARM_CONTACT_POINT ? 0.5 * overlap : 0.0;
  return {radius_a - half, planes ? 0.0 : radius_b - half};
}

// v_a − v_b + n × (arm_a ω_a + arm_b ω_b), the velocity of a's contact point relative to b's [D2].
template <int D, bool spin, class Spin>
[[gnu::always_inline]] inline Vec<D> contact_velocity(const Vec<D>& v, const Vec<D>& n, const Arms& arms,
                                                      const Spin& spin_a, const Spin& spin_b) {
  if constexpr (!spin) return v;
  const auto turning = arms.a * spin_a + arms.b * spin_b;
  if constexpr (D == 2)
    return v - cross(turning, n);
  else
    return v + cross(n, turning);
}

// One lane of a block: geometry and relative motion of a pair, as far as the law reads them. Differences are
// taken in double; what is left is rounded to what the law computes in.
template <int D, bool spin, bool planes, class T>
[[gnu::always_inline]] inline void gather_pair(const Scene& s, const scree_contact_instance& law,
                                               std::size_t pair, std::uint32_t lane, Buffers<T>& w) {
  const Particles& p = s.particles;
  const std::uint32_t a = s.contacts.a[pair], b = s.contacts.b[pair];
  const auto partner = [&] {
    if constexpr (planes)
      return plane_partner<D, spin>(s, a, b);
    else
      return body_partner<D, spin>(s, a, b, s.contacts.image[pair]);
  }();

  Vec<D> normal;
  const double distance = resolve<D, planes>(s, b, partner.separation, normal);
  const double radius_sum = p.radius[a] + partner.radius;
  const double overlap = radius_sum - distance;
  const Arms arms = arms_of<planes>(law.arms, p.radius[a], partner.radius, overlap);
  Vec<spin_components<D>> spin_a{}, mid_spin_a{};
  if constexpr (spin) spin_a = load_spin<D>(p.spin, a), mid_spin_a = load_spin<D>(p.mid_spin, a);

  const Vec<D> velocity = contact_velocity<D, spin>(load<D>(p.velocity, a) - partner.velocity, normal, arms,
                                                    spin_a, partner.spin_now);
  store<D>(w.input + SCREE_NORMAL, lane, normal);
  w.input[SCREE_OVERLAP][lane] = T(overlap);
  store<D>(w.input + SCREE_RELATIVE_VELOCITY, lane, velocity);
  w.input[SCREE_REDUCED_MASS][lane] = T(1 / (p.inverse_mass[a] + partner.inverse_mass));
  w.input[SCREE_EFFECTIVE_RADIUS][lane] = T(1 / (1 / p.radius[a] + partner.inverse_radius));
  w.arm_a[lane] = arms.a;
  w.arm_b[lane] = arms.b;
  w.overlap_ratio[lane] = overlap / (planes ? p.radius[a] : std::min(p.radius[a], partner.radius));
  if constexpr (spin)
    store<spin_components<D>>(w.input + SCREE_RELATIVE_SPIN, lane, spin_a - partner.spin_now);

  if (law.reads & (1u << SCREE_TANGENTIAL_INCREMENT)) {
    const Vec<D> mid_motion = load<D>(p.mid_velocity, a) - partner.mid_velocity;
    Vec<D> mid_normal;
    const double mid_distance =
        resolve<D, planes>(s, b, partner.separation - (0.5 * s.step) * mid_motion, mid_normal);
    const Arms mid_arms = arms_of<planes>(law.arms, p.radius[a], partner.radius, radius_sum - mid_distance);
    const Vec<D> slip = tangential_part(
        contact_velocity<D, spin>(mid_motion, mid_normal, mid_arms, mid_spin_a, partner.mid_spin),
        mid_normal);
    // A pair that met during this step has moved along its surface only since then.
    const double approach = -dot(velocity, normal) * s.step;
    const double touched = overlap < approach ? overlap / approach : 1.0;
    store<D>(w.input + SCREE_TANGENTIAL_INCREMENT, lane, (s.step * touched) * slip);
  }
}

// Padding lanes: finite numbers, not touching.
template <class T>
void fill_padding(std::uint32_t from, std::uint32_t to, Buffers<T>& w) {
  for (std::uint32_t lane = from; lane < to; ++lane) {
    for (auto& column : w.input) column[lane] = 1;
    w.input[SCREE_OVERLAP][lane] = -1;
    w.overlap_ratio[lane] = -1;
  }
}

// Force and torques of the block's pairs into their records.
template <int D, bool spin, class T>
void scatter(const scree_contact_instance& law, std::uint32_t count, const Buffers<T>& w, double* records) {
  constexpr int S = spin_components<D>;
  for (std::uint32_t lane = 0; lane < count; ++lane, records += record_width<D, spin>) {
    Vec<D> force, normal;
    for (int k = 0; k < D; ++k) {
      force[k] = records[k] = double(w.output[SCREE_FORCE + k][lane]);
      normal[k] = double(w.input[SCREE_NORMAL + k][lane]);
    }
    if constexpr (spin) {
      const Vec<S> lever = cross(normal, force);
      for (int k = 0; k < S; ++k) {
        const double couple = law.writes_couple ? double(w.output[SCREE_COUPLE + k][lane]) : 0.0;
        records[D + k] = -w.arm_a[lane] * lever[k] + couple;
        records[D + S + k] = -w.arm_b[lane] * lever[k] - couple;
      }
    }
  }
}

// Sum of a padded column in 8 interleaved parts: the same order for every vector width.
template <class T>
double sum_column(const T* column, std::uint32_t padded) {
  double part[SCREE_LANES] = {};
  for (std::uint32_t i = 0; i < padded; i += SCREE_LANES)
    for (std::uint32_t k = 0; k < SCREE_LANES; ++k) part[k] += double(column[i + k]);
  double sum = 0;
  for (const double p : part) sum += p;
  return sum;
}

inline double max_column(const double* column, std::uint32_t padded) {
  double part[SCREE_LANES] = {};
  for (std::uint32_t i = 0; i < padded; i += SCREE_LANES)
    for (std::uint32_t k = 0; k < SCREE_LANES; ++k) part[k] = std::max(part[k], column[i + k]);
  return *std::max_element(part, part + SCREE_LANES);
}

template <class T>
ContactSums sum_block(const Buffers<T>& w, std::uint32_t padded, bool audit) {
  ContactSums sums;
  sums.max_overlap_ratio = max_column(w.overlap_ratio, padded);
  if (!audit) return sums;
  sums.elastic_normal = sum_column(w.output[SCREE_ELASTIC_NORMAL], padded);
  sums.elastic_tangential = sum_column(w.output[SCREE_ELASTIC_TANGENTIAL], padded);
  sums.dissipated_normal = sum_column(w.output[SCREE_DISSIPATED_NORMAL], padded);
  sums.dissipated_tangential = sum_column(w.output[SCREE_DISSIPATED_TANGENTIAL], padded);
  sums.dissipated_friction = sum_column(w.output[SCREE_DISSIPATED_FRICTION], padded);
  return sums;
}

}  // namespace scree::kernel
