#pragma once

#include "block.hpp"

namespace scree::kernel {

// Record of a body. The barrier keeps GCC from computing four addresses in a vector and taking them out
// again.
template <int D, bool spin>
SCREE_HOT const double* record_of(const double* records, std::uint32_t body) {
  std::size_t index = body;
  __asm__("" : "+r"(index));
  return records + RecordLayout<D, spin>::width * index;
}

// One part of four records as columns.
SCREE_HOT void four_parts(const double* const (&record)[4], std::size_t part, Four (&out)[4]) {
  for (int k = 0; k < 4; ++k) out[k] = load_four(record[k] + part);
  transpose(out[0], out[1], out[2], out[3]);
}

// Differences of one part for four pairs, as columns.
SCREE_HOT void four_differences(const double* const (&a)[4], const double* const (&b)[4], std::size_t part,
                                Four (&out)[4]) {
  for (int k = 0; k < 4; ++k) out[k] = load_four(a[k] + part) - load_four(b[k] + part);
  transpose(out[0], out[1], out[2], out[3]);
}

// Whether any of four pairs reaches across a periodic face.
SCREE_HOT bool any_across(const std::uint8_t* image) {
  constexpr std::uint32_t none = 0x01010101u * Domain::no_shift;
  std::uint32_t images;
  __builtin_memcpy(&images, image, sizeof(images));
  return images != none;
}

template <class T>
SCREE_HOT void store_vector(T (*columns)[block_size], int count, std::uint32_t lane, const Four (&v)[4]) {
  for (int k = 0; k < count; ++k) store_lanes(columns[k] + lane, v[k]);
}

// Four pairs of bodies.
template <int D, bool spin, class T>
SCREE_HOT void gather_bodies(const Scene& s, std::size_t pair, std::uint32_t lane, Block<T>& w) {
  using Layout = RecordLayout<D, spin>;
  const double *a[4], *b[4];
  for (int k = 0; k < 4; ++k) {
    a[k] = record_of<D, spin>(s.records, s.contacts.a[pair + std::size_t(k)]);
    b[k] = record_of<D, spin>(s.records, s.contacts.b[pair + std::size_t(k)]);
  }
  const std::uint8_t* image = s.contacts.image.data() + pair;
  Four v[4];
  for (int k = 0; k < 4; ++k) v[k] = load_four(a[k] + Layout::place) - load_four(b[k] + Layout::place);
  if (s.periodic && any_across(image))
    for (int k = 0; k < 4; ++k) v[k] += load_four(s.shifts + 4 * image[k]);
  transpose(v[0], v[1], v[2], v[3]);
  store_vector(w.separation, D, lane, v);
  store_lanes(w.radius_difference + lane, v[3]);

  four_differences(a, b, Layout::motion, v);
  store_vector(w.velocity, D, lane, v);
  if constexpr (D == 2)
    for (int k = 0; k < 2; ++k) store_lanes(w.mid_velocity[k] + lane, v[2 + k]);
  if constexpr (D == 3 && spin) {
    four_differences(a, b, Layout::mid_motion, v);
    store_vector(w.mid_velocity, 3, lane, v);
  }
  if constexpr (spin)
    for (int side = 0; side < 2; ++side) {
      const auto& record = side == 0 ? a : b;
      four_parts(record, Layout::spin, v);
      store_vector(w.spin[side], spin_components<D>, lane, v);
      if constexpr (D == 2) store_lanes(w.mid_spin[side][0] + lane, v[1]);
      if constexpr (D == 3) {
        four_parts(record, Layout::mid_spin, v);
        store_vector(w.mid_spin[side], 3, lane, v);
      }
    }
}

// One pair of a body and a plane, which is a body of infinite radius and mass that does not turn: the
// contact point is the plane's, so that b has no arm.
template <int D, bool spin, class T>
SCREE_HOT void gather_plane(const Scene& s, std::size_t pair, std::uint32_t lane, Block<T>& w) {
  const Particles& p = s.particles;
  const std::uint32_t a = s.contacts.a[pair];
  const scree_plane& plane = s.planes[s.contacts.b[pair]];
  double distance = 0;
  for (int k = 0; k < D; ++k) distance += (p.position[k][a] - plane.point[k]) * plane.normal[k];
  for (int k = 0; k < D; ++k) {
    w.separation[k][lane] = distance * plane.normal[k];
    w.input[SCREE_NORMAL + k][lane] = T(plane.normal[k]);
    w.velocity[k][lane] = T(p.velocity[k][a] - plane.velocity[k]);
    w.mid_velocity[k][lane] = T(p.mid_velocity[k][a] - plane.mid_velocity[k]);
  }
  w.radius_difference[lane] = T(p.radius[a]);
  if constexpr (spin)
    for (int k = 0; k < spin_components<D>; ++k) {
      w.spin[0][k][lane] = T(p.spin[first_spin_axis<D> + k][a]);
      w.mid_spin[0][k][lane] = T(p.mid_spin[first_spin_axis<D> + k][a]);
      w.spin[1][k][lane] = w.mid_spin[1][k][lane] = T(0);
    }
}

// Lanes [first, first + count) of padding: they take no force, but must not hold what is no number.
template <class T>
SCREE_HOT void clear_lanes(std::uint32_t begin, std::uint32_t end, Block<T>& w) {
  for (std::uint32_t lane = begin; lane < end; ++lane)
    for (int k = 0; k < 3; ++k) {
      w.separation[k][lane] = 0;
      w.input[SCREE_NORMAL + k][lane] = w.velocity[k][lane] = w.mid_velocity[k][lane] = T(0);
      for (int side = 0; side < 2; ++side) w.spin[side][k][lane] = w.mid_spin[side][k][lane] = T(0);
      w.radius_difference[lane] = T(0);
    }
}

}  // namespace scree::kernel
