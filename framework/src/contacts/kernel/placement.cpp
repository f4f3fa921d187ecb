#include "contacts/kernel/placement.hpp"

namespace scree::kernel {

namespace {

template <bool planes>
void gather_orientations(const EvaluationInput& input, std::size_t begin, std::uint32_t count,
                         BlockColumns& block) {
  const Orientations& orientations = input.particles.orientations;
  const int components = orientations.components();
  const double* const values = orientations.data();
  const std::size_t stride = orientations.stride();
  for (int k = 0; k < components; ++k) {
    // The identity: angle 0, quaternion (1, 0, 0, 0).
    const double of_plane = components > 1 && k == 0 ? 1 : 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      block.orientation[0][k][i] = values[input.contacts.a[begin + i] * stride + std::size_t(k)];
      block.orientation[1][k][i] =
          planes ? of_plane : values[input.contacts.b[begin + i] * stride + std::size_t(k)];
    }
    block.batch.input[SCREE_ORIENTATION_A + k] = block.orientation[0][k];
    block.batch.input[SCREE_ORIENTATION_B + k] = block.orientation[1][k];
  }
}

// The separation from a plane is that along a path without periodic jumps.
template <bool planes>
void gather_separations(const EvaluationInput& input, std::size_t begin, std::uint32_t count,
                        BlockColumns& block) {
  for (int k = 0; k < input.particles.dimension(); ++k) {
    const bool unwrap = planes && input.domain.periodic[std::size_t(k)];
    const double length = input.domain.length(k);
    for (std::uint32_t i = 0; i < count; ++i) {
      const double crossed = unwrap ? length * input.particles.image[k][input.contacts.a[begin + i]] : 0.0;
      block.placement[k][i] = block.separation[k][i] + crossed;
    }
    block.batch.input[SCREE_SEPARATION + k] = block.placement[k];
  }
}

template <bool planes>
void gather_radii(const EvaluationInput& input, std::size_t begin, std::uint32_t count, BlockColumns& block) {
  const auto radius = input.particles.radius();
  for (std::uint32_t i = 0; i < count; ++i) {
    block.radius[0][i] = radius[input.contacts.a[begin + i]];
    block.radius[1][i] = planes ? 0 : radius[input.contacts.b[begin + i]];
  }
  for (int side = 0; side < 2; ++side) block.batch.input[SCREE_RADII + side] = block.radius[side];
}

}  // namespace

template <bool planes>
void gather_placement(const EvaluationInput& input, const scree_contact_instance& law, std::size_t begin,
                      std::uint32_t count, BlockColumns& block) {
  if (reads_orientations(law)) gather_orientations<planes>(input, begin, count, block);
  if (law.reads & (1u << SCREE_SEPARATION)) gather_separations<planes>(input, begin, count, block);
  if (law.reads & (1u << SCREE_RADII)) gather_radii<planes>(input, begin, count, block);
}

template void gather_placement<false>(const EvaluationInput&, const scree_contact_instance&, std::size_t,
                                      std::uint32_t, BlockColumns&);
template void gather_placement<true>(const EvaluationInput&, const scree_contact_instance&, std::size_t,
                                     std::uint32_t, BlockColumns&);

}  // namespace scree::kernel
