#pragma once

#include "body_force_terms.hpp"
#include "static_contacts.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/SparseCore>

namespace scree::response {

// A packing after a motion, and whether its forces and torques are in balance.
struct Balance {
  bool found = false;
  Eigen::VectorXd motion;  // numbered by Equilibrium::freedom
  StaticConfiguration at;
  StaticLoads loads;
};

// Searches for the motion that brings a packing into balance, by Newton's method with the derivatives of the laws.
class Equilibrium {
 public:
  // tolerance: as QuasiStaticOptions. Throws Error if a law has no derivatives.
  Equilibrium(const Simulation& simulation, double tolerance);

  const DegreesOfFreedom& freedom() const { return freedom_; }
  const StaticContacts& contacts() const { return contacts_; }
  std::size_t iterations() const { return iterations_; }  // so far

  // From a configuration, under the loads on walls at a time (s). guess: a motion, or empty. Motions that leave the known pairs of
  // contacts behind are not looked for, and nothing once `proceed` returns false.
  Balance find(const StaticConfiguration& from, double time, const Eigen::VectorXd& guess,
               const std::function<bool()>& proceed);
  // The balance that was found becomes the present state.
  void accept(const Balance& balance);

 private:
  using Vector = Eigen::VectorXd;
  using Sparse = Eigen::SparseMatrix<double>;

  // One search.
  struct Search {
    const StaticConfiguration& from;
    double time;  // (s)
    Balance balance;
    WallEquations walls;  // where the last evaluation has them
  };
  // Forces and torques that are not in balance after the motion.
  Vector evaluate(Search& search);
  void add_bodies(const Search& search, Vector& residual) const;
  void add_walls(const Search& search, Vector& residual) const;
  // Moves on by the largest share of a Newton step that makes the residual smaller: where contacts change between sticking and
  // sliding, the whole step may not. Returns this share, 0 if there is none.
  double move_along(Search& search, const Vector& step, Vector& residual);
  Sparse stiffness(const WallEquations& walls) const;  // K of the last evaluation
  std::optional<Vector> newton_step(const WallEquations& walls, const Vector& residual,
                                    double grounding) const;
  void shorten(Vector& step) const;

  double largest_force(const WallEquations& walls) const;
  double size_of(const Vector& residual) const { return residual.cwiseProduct(scale_).norm(); }
  // Largest displacement, of surfaces too (m).
  double length_of(const Vector& motion) const {
    return motion.cwiseQuotient(scale_).lpNorm<Eigen::Infinity>();
  }

  const Simulation& simulation_;
  double tolerance_;
  WallEquations walls_at_start_;
  DegreesOfFreedom freedom_;
  StaticContacts contacts_;
  std::vector<BodyForceTerms> body_forces_;
  std::vector<Vec3> at_start_;  // (m) bodies and walls
  // 1 for forces, 1/R for torques: makes them forces, and rotations over it lengths.
  Vector scale_;
  double smallest_radius_, moved_ = 0;  // (m) since pairs were searched for
  std::size_t iterations_ = 0;
};

}  // namespace scree::response
