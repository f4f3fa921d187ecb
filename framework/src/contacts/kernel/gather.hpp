#pragma once

#include "contacts/kernel/block.hpp"

namespace scree::kernel {

// Record of a body or of a plane. The barrier keeps GCC from computing four addresses in a vector register
// and extracting them again.
template <int D, bool spin>
SCREE_HOT const double* record_of(const double* records, std::uint32_t body) {
  std::size_t index = body;
  __asm__("" : "+r"(index));
  return records + record::width(D, spin) * index;
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

SCREE_HOT void store_vector(double (*columns)[block_size], int count, std::uint32_t lane,
                            const Four (&v)[4]) {
  for (int k = 0; k < count; ++k) store_four(columns[k] + lane, v[k]);
}

// Velocities and spins of four pairs of discs.
template <bool spin>
SCREE_HOT void gather_flat_motion(const double* const (&a)[4], const double* const (&b)[4], std::size_t part,
                                  double (*velocity)[block_size], double (*spin_a)[block_size],
                                  double (*spin_b)[block_size], std::uint32_t lane) {
  Four of_a[4], of_b[4];
  four_parts(a, part, of_a);
  four_parts(b, part, of_b);
  for (int k = 0; k < 2; ++k) store_four(velocity[k] + lane, of_a[k] - of_b[k]);
  if constexpr (spin) {
    store_four(spin_a[0] + lane, of_a[2]);
    store_four(spin_b[0] + lane, of_b[2]);
  }
}

// Velocities and spins of four pairs of spheres.
template <bool spin>
SCREE_HOT void gather_motion(const double* const (&a)[4], const double* const (&b)[4], std::uint32_t lane,
                             BlockColumns& block) {
  Four v[4];
  four_differences(a, b, record::motion, v);
  store_vector(block.velocity, 3, lane, v);
  if constexpr (spin) {
    four_differences(a, b, record::mid_motion, v);
    store_vector(block.mid_velocity, 3, lane, v);
    for (int side = 0; side < 2; ++side) {
      const auto& record = side == 0 ? a : b;
      four_parts(record, record::spin, v);
      store_vector(block.spin[side], 3, lane, v);
      four_parts(record, record::mid_spin, v);
      store_vector(block.mid_spin[side], 3, lane, v);
    }
  }
}

// Normals of four walls, and of surfaces the place from the origin of the frame.
template <int D, Partner partner>
SCREE_HOT void gather_walls(const EvaluationInput& s, std::size_t pair, std::size_t row, std::uint32_t lane,
                            BlockColumns& block) {
  Four v[4];
  for (std::size_t k = 0; k < 4; ++k)
    v[k] = load_four(partner == Partner::surface ? s.surfaces->normals() + 4 * (row + k)
                                                 : s.planes.normals() + 4 * s.contacts.b[pair + k]);
  transpose(v[0], v[1], v[2], v[3]);
  store_vector(block.input + SCREE_NORMAL, D, lane, v);
  if constexpr (partner == Partner::surface) {
    const auto gather = [&](const double* vectors, double(*columns)[block_size]) SCREE_INLINE_LAMBDA {
      for (std::size_t k = 0; k < 4; ++k) v[k] = load_four(vectors + 4 * (row + k));
      transpose(v[0], v[1], v[2], v[3]);
      store_vector(columns, D, lane, v);
    };
    gather(s.surfaces->levers(), block.lever);
    gather(s.surfaces->mid_normals(), block.mid_normal);
  }
}

// Gathers four pairs of bodies, or of a body and a wall. A wall is treated as a body without radius. row: of
// surface records.
template <int D, bool spin, Partner partner>
SCREE_HOT void gather_four(const EvaluationInput& s, std::size_t pair, std::size_t row, std::uint32_t lane,
                           BlockColumns& block) {
  constexpr bool planes = is_wall(partner);
  const double *a[4], *b[4];
  for (int k = 0; k < 4; ++k) {
    a[k] = record_of<D, spin>(s.records, s.contacts.a[pair + std::size_t(k)]);
    if constexpr (partner == Partner::surface)
      b[k] = s.surfaces->records() + record::width(D, spin) * (row + std::size_t(k));
    else
      b[k] = record_of<D, spin>(planes ? s.planes.records() : s.records, s.contacts.b[pair + std::size_t(k)]);
  }
  Four v[4];
  for (int k = 0; k < 4; ++k) v[k] = load_four(a[k] + record::position) - load_four(b[k] + record::position);
  const std::uint8_t* image = s.contacts.image.data() + pair;
  if (!planes && s.periodic && any_across(image))
    for (int k = 0; k < 4; ++k) v[k] += load_four(s.shifts + 4 * image[k]);
  transpose(v[0], v[1], v[2], v[3]);
  store_vector(block.separation, D, lane, v);
  store_four(block.radius_difference + lane, v[3]);
  if constexpr (planes) gather_walls<D, partner>(s, pair, row, lane, block);
  if constexpr (D == 2) {
    gather_flat_motion<spin>(a, b, record::motion, block.velocity, block.spin[0], block.spin[1], lane);
    gather_flat_motion<spin>(a, b, record::mid_motion, block.mid_velocity, block.mid_spin[0],
                             block.mid_spin[1], lane);
  } else {
    gather_motion<spin>(a, b, lane, block);
  }
}

// Padding lanes [begin, end) refer to real bodies and planes: their separation is set to 0, so that they do
// not touch.
SCREE_HOT void separate_padding(std::uint32_t begin, std::uint32_t end, BlockColumns& block) {
  for (std::uint32_t lane = begin; lane < end; ++lane)
    for (int k = 0; k < 3; ++k) block.separation[k][lane] = 0;
}

}  // namespace scree::kernel
