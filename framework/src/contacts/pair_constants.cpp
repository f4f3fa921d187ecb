#include "contacts/pair_constants.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <scree/contact_kinematics.hpp>

namespace scree {

namespace {

// What pairs combine, in columns that fit into a cache, unlike the records of the bodies.
struct BodyColumns {
  std::vector<double> radius, curvature, inverse_mass;

  explicit BodyColumns(const Particles& p)
      : radius(p.radius().begin(), p.radius().end()),
        curvature(p.size()),
        inverse_mass(p.inverse_mass().begin(), p.inverse_mass().end()) {
    for (std::size_t i = 0; i < p.size(); ++i) curvature[i] = 1 / radius[i];
  }
};

}  // namespace

void PairConstants::update(const Contacts& contacts, const Particles& p, std::uint32_t reads, bool forces) {
  const std::size_t all = contacts.padded_size();
  resize_with_room(radius_sum, all);
  force.reset(forces ? std::uint32_t(p.dimension()) : 0, all);
  for (std::uint32_t k = 0; k < column_count; ++k)
    terms[k].resize(reads & (1u << (SCREE_REDUCED_MASS + k)) ? 1 : 0, all);
  const BodyColumns bodies(p);
  for (const PairGroup& group : contacts.groups()) {
    const auto set = [&](auto* column, const auto& value) {
      for (const PairRun& run : group.runs)
        for (std::size_t q = run.begin; q < run.begin + run.padded_size(); ++q)
          column[q] = value(contacts.a[q], contacts.b[q]);
    };
    const auto mass = [&](std::uint32_t a, std::uint32_t b) {
      return group.planes ? reduced_mass(p.inverse_mass_at_wall(a), 0)
                          : reduced_mass(bodies.inverse_mass[a], bodies.inverse_mass[b]);
    };
    const auto set_term = [&](scree_contact_input input, const auto& value) {
      PairColumns& term = terms[input - SCREE_REDUCED_MASS];
      if (term.size() > 0) set(term.column(0), value);
    };
    set(radius_sum.data(), [&](std::uint32_t a, std::uint32_t b) {
      return group.planes ? bodies.radius[a] : bodies.radius[a] + bodies.radius[b];
    });
    set_term(SCREE_REDUCED_MASS, mass);
    set_term(SCREE_REDUCED_MASS_ROOT,
             [&](std::uint32_t a, std::uint32_t b) { return std::sqrt(mass(a, b)); });
    set_term(SCREE_EFFECTIVE_RADIUS, [&](std::uint32_t a, std::uint32_t b) {
      return group.planes ? bodies.radius[a] : 1 / (bodies.curvature[a] + bodies.curvature[b]);
    });
    for (const PairRun& run : group.runs)
      std::fill(radius_sum.begin() + std::ptrdiff_t(run.end),
                radius_sum.begin() + std::ptrdiff_t(run.begin + run.padded_size()), -1.0);
  }
}

std::size_t PairConstants::bytes_per_pair() const {
  std::size_t columns = 1 + force.width();
  for (const PairColumns& term : terms) columns += term.width();
  return columns * sizeof(double);
}

}  // namespace scree
