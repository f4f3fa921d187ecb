#include "contacts/pair_constants.hpp"

#include "machine/instruction_levels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree {

namespace {

// What pairs combine, in columns that fit into a cache, unlike the records of the bodies.
struct BodyColumns {
  std::vector<double> radius, curvature, inverse_mass, inverse_mass_at_wall;

  BodyColumns(const Particles& p, bool walls)
      : radius(p.size()),
        curvature(p.size()),
        inverse_mass(p.size()),
        inverse_mass_at_wall(walls ? p.size() : 0) {
    for (std::size_t i = 0; i < p.size(); ++i) {  // one pass over the records
      radius[i] = p.radius()[i];
      curvature[i] = 1 / radius[i];
      inverse_mass[i] = p.inverse_mass()[i];
      if (walls) inverse_mass_at_wall[i] = p.inverse_mass_at_wall(i);
    }
  }
};

// The partners of the pairs of a group, padding included, and what they combine.
struct Partners {
  const std::uint32_t *a, *b;
  std::size_t pairs;
};

// x_a + y_b of each pair.
SCREE_EVERY_LEVEL void add(const Partners& of, const double* x, const double* y, double* sum) {
  for (std::size_t q = 0; q < of.pairs; ++q) sum[q] = x[of.a[q]] + y[of.b[q]];
}

// 1 / (x_a + y_b) of each pair: its reduced mass, or its effective radius.
SCREE_EVERY_LEVEL void add_inverse(const Partners& of, const double* x, const double* y, double* inverse) {
  for (std::size_t q = 0; q < of.pairs; ++q) inverse[q] = 1 / (x[of.a[q]] + y[of.b[q]]);
}

void set_constants(PairConstants& constants, const Contacts& contacts, const PairGroup& group,
                   const BodyColumns& bodies) {
  const Partners of = {contacts.a.data() + group.begin, contacts.b.data() + group.begin, group.padded_size()};
  // A plane adds nothing to radii and inverse masses.
  const std::uint32_t planes =
      group.planes && of.pairs > 0 ? 1 + *std::max_element(of.b, of.b + of.pairs) : 0;
  const std::vector<double> nothing(planes);
  const auto of_b = [&](const std::vector<double>& column) { return (planes > 0 ? nothing : column).data(); };
  const auto term = [&](scree_contact_input input) {
    PairColumns& column = constants.terms[input - SCREE_REDUCED_MASS];
    return column.size() > 0 ? column.column(0) + group.begin : nullptr;
  };
  const std::vector<double>& inverse_mass = planes > 0 ? bodies.inverse_mass_at_wall : bodies.inverse_mass;
  add(of, bodies.radius.data(), of_b(bodies.radius), constants.radius_sum.data() + group.begin);
  if (double* const mass = term(SCREE_REDUCED_MASS))
    add_inverse(of, inverse_mass.data(), of_b(inverse_mass), mass);
  if (double* const root = term(SCREE_REDUCED_MASS_ROOT)) {
    add_inverse(of, inverse_mass.data(), of_b(inverse_mass), root);
    std::transform(root, root + of.pairs, root, [](double mass) { return std::sqrt(mass); });
  }
  if (double* const radius = term(SCREE_EFFECTIVE_RADIUS)) {
    if (planes > 0)
      add(of, bodies.radius.data(), nothing.data(), radius);
    else
      add_inverse(of, bodies.curvature.data(), bodies.curvature.data(), radius);
  }
  for (const PairRun& run : group.runs)
    std::fill(constants.radius_sum.begin() + std::ptrdiff_t(run.end),
              constants.radius_sum.begin() + std::ptrdiff_t(run.begin + run.padded_size()), -1.0);
}

}  // namespace

void PairConstants::update(const Contacts& contacts, const Particles& p, std::uint32_t reads, bool forces) {
  const std::size_t all = contacts.padded_size();
  resize_with_room(radius_sum, all);
  force.reset(forces ? std::uint32_t(p.dimension()) : 0, all);
  for (std::uint32_t k = 0; k < column_count; ++k)
    terms[k].resize(reads & (1u << (SCREE_REDUCED_MASS + k)) ? 1 : 0, all);
  const auto has_pairs_with_planes = [](const PairGroup& group) { return group.planes && group.pairs > 0; };
  const BodyColumns bodies(
      p, std::any_of(contacts.groups().begin(), contacts.groups().end(), has_pairs_with_planes));
  for (const PairGroup& group : contacts.groups()) set_constants(*this, contacts, group, bodies);
}

std::size_t PairConstants::bytes_per_pair() const {
  std::size_t columns = 1 + force.width();
  for (const PairColumns& term : terms) columns += term.width();
  return columns * sizeof(double);
}

}  // namespace scree
