#include <scree/pair_constants.hpp>

namespace scree {

void PairConstants::update(const Contacts& contacts, const Particles& p) {
  const std::size_t all = contacts.padded_size();
  radius_sum.assign(all, -1.0);
  terms.reset(column_count, all);
  force.reset(std::uint32_t(p.dimension()), all);
  for (std::size_t q = 0; q < all; ++q)
    for (std::uint32_t k = 0; k < column_count; ++k) terms.set(k, q, 1);
  for (const PairGroup& group : contacts.groups())
    for (std::size_t q = group.begin; q < group.end; ++q) {
      const std::uint32_t a = contacts.a[q], b = contacts.b[q];
      radius_sum[q] = p.radius[a] + (group.planes ? 0 : p.radius[b]);
      terms.set(reduced_mass, q, 1 / (p.inverse_mass[a] + (group.planes ? 0 : p.inverse_mass[b])));
      terms.set(effective_radius, q, group.planes ? p.radius[a] : 1 / (1 / p.radius[a] + 1 / p.radius[b]));
    }
}

}  // namespace scree
