#include "contacts/kernel/placement.hpp"

namespace scree::kernel {

namespace {

// The identity: angle 0, quaternion (1, 0, 0, 0).
double identity(int components, int k) { return components > 1 && k == 0 ? 1 : 0; }

template <Partner partner>
void gather_orientations(const PairsToPlace& pairs, BlockColumns& block) {
  const Contacts& contacts = pairs.input.contacts;
  const Orientations& orientations = pairs.input.particles.orientations;
  const int components = orientations.components();
  const double* const values = orientations.data();
  const std::size_t stride = orientations.stride();
  const auto of_body = [&](std::uint32_t body, int k) { return values[body * stride + std::size_t(k)]; };
  for (int k = 0; k < components; ++k) {
    for (std::uint32_t i = 0; i < pairs.count; ++i) {
      block.orientation[0][k][i] = of_body(contacts.a[pairs.begin + i], k);
      if constexpr (partner == Partner::body)
        block.orientation[1][k][i] = of_body(contacts.b[pairs.begin + i], k);
      else if constexpr (partner == Partner::plane)
        block.orientation[1][k][i] = identity(components, k);
      else
        block.orientation[1][k][i] = pairs.input.surfaces->orientation(pairs.surface_row + i)[k];
    }
    block.batch.input[SCREE_ORIENTATION_A + k] = block.orientation[0][k];
    block.batch.input[SCREE_ORIENTATION_B + k] = block.orientation[1][k];
  }
}

// The separation from a wall is that along a path without periodic jumps.
template <Partner partner>
void gather_separations(const PairsToPlace& pairs, BlockColumns& block) {
  const EvaluationInput& input = pairs.input;
  for (int k = 0; k < input.particles.dimension(); ++k) {
    const bool unwrap = is_wall(partner) && input.domain.periodic[std::size_t(k)];
    const double length = input.domain.length(k);
    for (std::uint32_t i = 0; i < pairs.count; ++i) {
      const std::uint32_t a = input.contacts.a[pairs.begin + i];
      double crossed = unwrap ? length * input.particles.image[k][a] : 0.0;
      // Surfaces are met in the domain.
      if (partner == Partner::surface && unwrap)
        crossed += input.domain.beyond(k, input.particles.position()[k][a]);
      const double from_origin = partner == Partner::surface ? block.lever[k][i] : 0.0;
      block.placement[k][i] = block.separation[k][i] + from_origin + crossed;
    }
    block.batch.input[SCREE_SEPARATION + k] = block.placement[k];
  }
}

template <Partner partner>
void gather_radii(const PairsToPlace& pairs, BlockColumns& block) {
  const auto radius = pairs.input.particles.radius();
  const Contacts& contacts = pairs.input.contacts;
  for (std::uint32_t i = 0; i < pairs.count; ++i) {
    block.radius[0][i] = radius[contacts.a[pairs.begin + i]];
    block.radius[1][i] = is_wall(partner) ? 0 : radius[contacts.b[pairs.begin + i]];
  }
  for (int side = 0; side < 2; ++side) block.batch.input[SCREE_RADII + side] = block.radius[side];
}

// Of a surface; other pairs have none.
template <Partner partner>
void gather_normal_changes(const PairsToPlace& pairs, BlockColumns& block) {
  for (int k = 0; k < 6; ++k) {
    block.batch.input[SCREE_NORMAL_CHANGE + k] = nullptr;
    if constexpr (partner == Partner::surface) {
      for (std::uint32_t i = 0; i < pairs.count; ++i)
        block.normal_change[k][i] = pairs.input.surfaces->normal_change(pairs.surface_row + i)[k];
      block.batch.input[SCREE_NORMAL_CHANGE + k] = block.normal_change[k];
    }
  }
}

}  // namespace

template <Partner partner>
void gather_placement(const PairsToPlace& pairs, const scree_contact_instance& law, BlockColumns& block) {
  if (reads_orientations(law)) gather_orientations<partner>(pairs, block);
  if (law.reads & (1u << SCREE_SEPARATION)) gather_separations<partner>(pairs, block);
  if (law.reads & (1u << SCREE_RADII)) gather_radii<partner>(pairs, block);
  if (law.follows_surfaces) gather_normal_changes<partner>(pairs, block);
}

template void gather_placement<Partner::body>(const PairsToPlace&, const scree_contact_instance&,
                                              BlockColumns&);
template void gather_placement<Partner::plane>(const PairsToPlace&, const scree_contact_instance&,
                                               BlockColumns&);
template void gather_placement<Partner::surface>(const PairsToPlace&, const scree_contact_instance&,
                                                 BlockColumns&);

}  // namespace scree::kernel
