#pragma once

#include "assembly/contact_terms.hpp"
#include "assembly/turn_terms.hpp"

#include <cstdint>
#include <vector>

#include <Eigen/SparseCore>

#include <scree/response/degrees_of_freedom.hpp>
#include <scree/wall_equations.hpp>

namespace scree::response {

// Collects and sums the entries of two matrices: (q, q), and (q, walls × dimension) for given displacements w
// of the walls. A wall with the direction e that is numbered in q is displaced by q e and, across e, by w;
// other walls by w.
class Entries {
 public:
  Entries(const DegreesOfFreedom& freedom, const WallEquations& equations)
      : freedom_(freedom), equations_(equations) {}

  // Adds the block of the bodies `ends`; numbers from freedom.bodies() on are walls.
  void add(const std::vector<std::uint32_t>& ends, const Block& block);
  // Adds what a contact of a body adds by the turn of a wall that is numbered in q.
  void add_turn(std::uint32_t body, std::size_t wall, const TurnTerms& terms);
  // Adds the torque on a wall per angle of its own.
  void add_own_turn(std::size_t wall, double value) {
    motions_.emplace_back(freedom_.turn(wall), freedom_.turn(wall), value);
  }
  // Adds the force on wall w along its direction per displacement of wall `moved` along the direction of
  // `moved`.
  void add_along(std::size_t w, std::size_t moved, double value);
  // Adds the force on wall w per motion q − w.
  void add_inertial(std::size_t w, double value);

  Eigen::SparseMatrix<double> of_motions() const { return matrix(motions_, freedom_.size()); }
  Eigen::SparseMatrix<double> of_walls() const {
    return matrix(walls_, Eigen::Index(freedom_.walls()) * freedom_.dimension());
  }

 private:
  using Triplet = Eigen::Triplet<double>;
  // A component of the motion of a body or wall in terms of q.
  struct Share {
    Eigen::Index number;
    double weight;
  };

  Share share(std::uint32_t end, int k) const;
  void add_to_wall(Eigen::Index row, std::size_t wall, int k, double value);
  // Adds to the columns of w for a displacement along the direction of the wall.
  void add_to_wall_along(Eigen::Index row, std::size_t wall, double value);
  Eigen::Index column(std::size_t wall, int k) const { return Eigen::Index(wall) * freedom_.dimension() + k; }
  Eigen::SparseMatrix<double> matrix(const std::vector<Triplet>& entries, Eigen::Index columns) const;

  const DegreesOfFreedom& freedom_;
  const WallEquations& equations_;
  std::vector<Triplet> motions_, walls_;
};

}  // namespace scree::response
