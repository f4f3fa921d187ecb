#include "body_force_terms.hpp"
#include "contact_terms.hpp"
#include "held_bodies.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/response/linear_system.hpp>

namespace scree::response {

namespace {

// Sparse matrices while their entries are collected, which are summed.
class Entries {
 public:
  explicit Entries(const DegreesOfFreedom& freedom) : freedom_(freedom) {}

  // Adds the block of bodies `ends`; a number from freedom.bodies() on is a wall.
  void add(const std::vector<std::uint32_t>& ends, const Block& block) {
    const int of_body = freedom_.dimension() + freedom_.spins();
    for (Eigen::Index r = 0; r < block.rows(); ++r) {
      const Eigen::Index row = number(ends[std::size_t(r / of_body)], int(r % of_body));
      if (row == DegreesOfFreedom::none) continue;
      for (Eigen::Index c = 0; c < block.cols(); ++c) {
        const std::uint32_t end = ends[std::size_t(c / of_body)];
        const int k = int(c % of_body);
        const Eigen::Index column = number(end, k);
        if (column != DegreesOfFreedom::none)
          bodies_.emplace_back(row, column, block(r, c));
        else if (end >= freedom_.bodies() && k < freedom_.dimension())
          walls_.emplace_back(row, wall_column(end, k), block(r, c));
      }
    }
  }

  Eigen::SparseMatrix<double> of_bodies() const { return matrix(bodies_, freedom_.size()); }
  Eigen::SparseMatrix<double> of_walls(std::size_t walls) const {
    return matrix(walls_, Eigen::Index(walls) * freedom_.dimension());
  }

 private:
  using Entry = Eigen::Triplet<double>;

  Eigen::Index number(std::uint32_t end, int k) const {
    if (end >= freedom_.bodies()) return DegreesOfFreedom::none;
    return k < freedom_.dimension() ? freedom_.translation(end, k)
                                    : freedom_.rotation(end, k - freedom_.dimension());
  }
  Eigen::Index wall_column(std::uint32_t end, int k) const {
    return Eigen::Index(end - freedom_.bodies()) * freedom_.dimension() + k;
  }
  Eigen::SparseMatrix<double> matrix(const std::vector<Entry>& entries, Eigen::Index columns) const {
    Eigen::SparseMatrix<double> sum(freedom_.size(), columns);
    sum.setFromTriplets(entries.begin(), entries.end());
    return sum;
  }

  const DegreesOfFreedom& freedom_;
  std::vector<Entry> bodies_, walls_;
};

// Bodies rotate if a contact between held bodies can turn them.
DegreesOfFreedom number_motions(const std::vector<ContactTerms>& contacts, const std::vector<bool>& held,
                                int dimension, int spins) {
  std::vector<bool> rotates(held.size(), false);
  for (const ContactTerms& c : contacts) {
    if (!c.tangential || !held[c.a] || (c.b < held.size() && !held[c.b])) continue;
    rotates[c.a] = true;
    if (c.b < held.size()) rotates[c.b] = true;
  }
  return DegreesOfFreedom(dimension, spins, held, rotates);
}

Eigen::VectorXd masses(const DegreesOfFreedom& freedom, const Particles& p) {
  Eigen::VectorXd mass(freedom.size());
  for (std::size_t i = 0; i < freedom.bodies(); ++i) {
    if (freedom.translation(i, 0) != DegreesOfFreedom::none)
      mass.segment(freedom.translation(i, 0), freedom.dimension()).setConstant(p.mass[i]);
    if (freedom.rotation(i, 0) != DegreesOfFreedom::none)
      mass.segment(freedom.rotation(i, 0), freedom.spins()).setConstant(p.inertia[i]);
  }
  return mass;
}

}  // namespace

LinearSystem assemble(const Simulation& simulation, const AssemblyOptions& options) {
  const Particles& p = simulation.particles();
  const int spins = p.spin_axes().last - p.spin_axes().first;
  const std::vector<ContactTerms> contacts = linearise_contacts(simulation, spins);
  const std::vector<bool> held =
      held_bodies(contacts, p.size(), simulation.dimension(), options.fewest_contacts);
  const DegreesOfFreedom freedom = number_motions(contacts, held, simulation.dimension(), spins);
  if (freedom.size() == 0)
    throw Error(fmt::format("no body is held at t = {:g} s, of {} with {} contacts; compress the packing",
                            simulation.time(), p.size(), contacts.size()));

  Entries stiffness(freedom), damping(freedom);
  for (const ContactTerms& contact : contacts) {
    if (!held[contact.a] || (contact.b < p.size() && !held[contact.b])) continue;
    stiffness.add({contact.a, contact.b}, contact.stiffness);
    damping.add({contact.a, contact.b}, contact.damping);
  }
  const std::vector<BodyForceTerms> forces = linearise_body_forces(simulation, spins);
  for (std::uint32_t i = 0; i < forces.size(); ++i) {
    stiffness.add({i}, forces[i].stiffness);
    damping.add({i}, forces[i].damping);
  }

  std::vector<std::uint32_t> rattlers;
  for (std::uint32_t i = 0; i < p.size(); ++i)
    if (!held[i]) rattlers.push_back(i);
  const std::size_t walls = simulation.planes().size();
  return {.freedom = freedom,
          .stiffness = stiffness.of_bodies(),
          .damping = damping.of_bodies(),
          .mass = masses(freedom, p),
          .wall_stiffness = stiffness.of_walls(walls),
          .wall_damping = damping.of_walls(walls),
          .rattlers = rattlers};
}

}  // namespace scree::response
