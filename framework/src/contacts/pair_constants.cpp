#include "contacts/pair_constants.hpp"

#include "machine/instruction_levels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree {

namespace {

std::vector<char> tiles_with_pairs(const Contacts& contacts, std::size_t tiles) {
  std::vector<char> has_pairs(tiles, 0);
  for (const PairGroup& group : contacts.groups())
    for (std::size_t t = 0; t < group.runs.size(); ++t)
      has_pairs[t] |= group.runs[t].end > group.runs[t].begin;
  return has_pairs;
}

// What pairs combine, in columns that fit into a cache, unlike the records of the bodies.
struct BodyColumns {
  BodyColumn<double> radius, curvature, inverse_mass, inverse_mass_at_wall;
  BodyColumn<double> nothing;  // of each plane: it adds nothing to radii and inverse masses

  BodyColumns(const Particles& p, const Contacts& contacts, std::size_t planes, ThreadPool& threads)
      : radius(p.size()),
        curvature(p.size()),
        inverse_mass(p.size()),
        inverse_mass_at_wall(planes > 0 ? p.size() : 0),
        nothing(planes) {
    const BodyTiles tiles(p.size());
    const std::vector<char> has_pairs = tiles_with_pairs(contacts, tiles.count());
    threads.each(tiles.count(), [&](std::size_t t, unsigned) {
      for (std::size_t i = tiles[t].begin; has_pairs[t] && i < tiles[t].end; ++i) take(p, i);
    });
    // Of a tile without pairs, only bodies that pairs of other tiles have.
    for (const PairGroup& group : contacts.groups())
      for (std::size_t t = 0; !group.planes && t < group.runs.size(); ++t)
        for (std::size_t q = group.runs[t].crossing; q < group.runs[t].end; ++q)
          for (const std::uint32_t i : {contacts.a[q], contacts.b[q]})
            if (!has_pairs[tiles.owner(i)]) take(p, i);
  }

  void take(const Particles& p, std::size_t i) {
    radius[i] = p.radius()[i];
    curvature[i] = 1 / radius[i];
    inverse_mass[i] = p.inverse_mass()[i];
    if (!inverse_mass_at_wall.empty()) inverse_mass_at_wall[i] = p.inverse_mass_at_wall(i);
  }
};

// Number of planes that pairs may name.
std::size_t planes_in(const Contacts& contacts) {
  std::size_t planes = 0;
  for (const PairGroup& group : contacts.groups())
    if (group.planes)
      group.each_pair([&](std::size_t q) { planes = std::max<std::size_t>(planes, contacts.b[q] + 1); });
  return planes;
}

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

// For a run of pairs with bodies or with planes.
void set_constants(PairConstants& constants, const Contacts& contacts, const PairRun& run, bool planes,
                   const BodyColumns& bodies) {
  const Partners of = {contacts.a.data() + run.begin, contacts.b.data() + run.begin, run.padded_size()};
  const auto of_b = [&](const BodyColumn<double>& column) {
    return (planes ? bodies.nothing : column).data();
  };
  const auto term = [&](scree_contact_input input) {
    PairColumns& column = constants.terms[input - SCREE_REDUCED_MASS];
    return column.size() > 0 ? column.column(0) + run.begin : nullptr;
  };
  const BodyColumn<double>& inverse_mass = planes ? bodies.inverse_mass_at_wall : bodies.inverse_mass;
  double* const radius_sum = constants.radius_sum.data() + run.begin;
  add(of, bodies.radius.data(), of_b(bodies.radius), radius_sum);
  if (double* const radius = term(SCREE_EFFECTIVE_RADIUS))
    planes ? void(std::copy(radius_sum, radius_sum + of.pairs, radius))
           : add_inverse(of, bodies.curvature.data(), bodies.curvature.data(), radius);
  if (double* const mass = term(SCREE_REDUCED_MASS))
    add_inverse(of, inverse_mass.data(), of_b(inverse_mass), mass);
  if (double* const root = term(SCREE_REDUCED_MASS_ROOT)) {
    add_inverse(of, inverse_mass.data(), of_b(inverse_mass), root);
    std::transform(root, root + of.pairs, root, [](double mass) { return std::sqrt(mass); });
  }
  std::fill(radius_sum + (run.end - run.begin), radius_sum + run.padded_size(), -1.0);
}

}  // namespace

void PairConstants::update(const Contacts& contacts, const Particles& p, std::uint32_t reads, bool forces,
                           ThreadPool& threads) {
  const std::size_t all = contacts.padded_size();
  resize_with_room(radius_sum, all);
  force.reset(forces ? std::uint32_t(p.dimension()) : 0, all);
  for (std::uint32_t k = 0; k < column_count; ++k)
    terms[k].resize(reads & (1u << (SCREE_REDUCED_MASS + k)) ? 1 : 0, all);
  const BodyColumns bodies(p, contacts, planes_in(contacts), threads);
  for (const PairGroup& group : contacts.groups())
    threads.each(group.runs.size(), [&](std::size_t t, unsigned) {
      set_constants(*this, contacts, group.runs[t], group.planes, bodies);
    });
}

std::size_t PairConstants::bytes_per_pair() const {
  std::size_t columns = 1 + force.width();
  for (const PairColumns& term : terms) columns += term.width();
  return columns * sizeof(double);
}

}  // namespace scree
