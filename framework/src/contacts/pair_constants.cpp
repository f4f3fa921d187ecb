#include "contacts/pair_constants.hpp"

#include <cmath>

#include <scree/contact_kinematics.hpp>

namespace scree {

void PairConstants::update(const Contacts& contacts, const Particles& p, std::uint32_t reads, bool forces) {
  const std::size_t all = contacts.padded_size();
  resize_with_room(radius_sum, all);
  force.reset(forces ? std::uint32_t(p.dimension()) : 0, all);
  for (std::uint32_t k = 0; k < column_count; ++k) {
    const bool read = reads & (1u << (SCREE_REDUCED_MASS + k));
    terms[k].resize(read ? 1 : 0, all);
  }
  const auto set = [this](scree_contact_input column, std::size_t q, double value) {
    PairColumns& term = terms[column - SCREE_REDUCED_MASS];
    if (term.size() > 0) term.column(0)[q] = value;
  };
  for (const PairGroup& group : contacts.groups()) {
    group.each_pair([&](std::size_t q) {
      const std::uint32_t a = contacts.a[q], b = contacts.b[q];
      const double mass = group.planes ? reduced_mass(p.inverse_mass_at_wall(a), 0)
                                       : reduced_mass(p.inverse_mass()[a], p.inverse_mass()[b]);
      const double radius_a = p.radius()[a], radius_b = group.planes ? 0 : p.radius()[b];
      radius_sum[q] = radius_a + radius_b;
      set(SCREE_REDUCED_MASS, q, mass);
      set(SCREE_REDUCED_MASS_ROOT, q, std::sqrt(mass));
      set(SCREE_EFFECTIVE_RADIUS, q, effective_radius(radius_a, radius_b, group.planes));
    });
    for (const PairRun& run : group.runs)
      for (std::size_t q = run.end; q < run.begin + run.padded_size(); ++q) {
        radius_sum[q] = -1;
        for (PairColumns& term : terms)
          if (term.size() > 0) term.column(0)[q] = 1;
      }
  }
}

std::size_t PairConstants::bytes_per_pair() const {
  std::size_t columns = 1 + force.width();
  for (const PairColumns& term : terms) columns += term.width();
  return columns * sizeof(double);
}

}  // namespace scree
