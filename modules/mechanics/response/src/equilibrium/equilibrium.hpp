#pragma once

#include "assembly/body_force_terms.hpp"
#include "equilibrium/static_contacts.hpp"
#include "equilibrium/stiffness_factors.hpp"

#include <cstddef>
#include <functional>
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

// Searches for the motion that brings a packing into balance, by Newton's method with the derivatives of the
// laws.
class Equilibrium {
 public:
  // tolerance: as QuasiStaticOptions. Throws Error if a law has no derivatives.
  Equilibrium(const Simulation& simulation, double tolerance);

  const DegreesOfFreedom& freedom() const { return freedom_; }
  const StaticContacts& contacts() const { return contacts_; }
  std::size_t iterations() const { return iterations_; }  // so far

  // Searches from a configuration, under the loads on walls at a time (s). guess: a motion, or empty. The
  // search ends without a balance where the motion exceeds the range of the listed pairs, or once `proceed`
  // returns false.
  Balance find(const StaticConfiguration& from, double time, const Eigen::VectorXd& guess,
               const std::function<bool()>& proceed);
  // Makes the balance that was found the present state.
  void accept(const Balance& balance);

  // A motion with 0 for bodies that touched nothing in the last evaluation: without inertia they stay where
  // they are.
  Eigen::VectorXd without_free_bodies(Eigen::VectorXd motion) const;

 private:
  using Vector = Eigen::VectorXd;
  using Sparse = Eigen::SparseMatrix<double>;

  // One search.
  struct Search {
    const StaticConfiguration& from;
    double time;  // (s)
    Balance balance;
    WallEquations walls;  // in the last evaluation
  };
  // The net forces and torques after the motion.
  Vector evaluate(Search& search);
  void add_bodies(const Search& search, Vector& residual) const;
  void add_walls(const Search& search, Vector& residual) const;
  // Backtracking line search: takes the largest fraction of `step` (at least `shortest`) that reduces the
  // residual by `gain` × that fraction. A full Newton step can fail where contacts switch between stick and
  // slip. Returns the fraction, 0 if none works.
  double move_along(Search& search, const Vector& step, double shortest, double gain, Vector& residual);
  Sparse stiffness(const WallEquations& walls) const;  // K of the last evaluation
  // Factorises K with `grounding` × its largest entry added to the diagonal. Returns false if it is singular.
  bool factorise(const WallEquations& walls, double grounding);
  Vector step_for(const Vector& residual) const;
  // Calls visit(first number, count) for the translation and the rotation of each body that moves.
  template <class Visit>
  void for_each_motion(const Visit& visit) const {
    for (std::size_t i = 0; i < freedom_.bodies(); ++i) {
      if (!freedom_.moves(i)) continue;
      for (const auto& [first, count] : {freedom_.translations(i), freedom_.rotations(i)})
        if (count > 0) visit(first, count);
    }
  }

  double largest_force(const WallEquations& walls) const;
  double size_of(const Vector& residual) const { return residual.cwiseProduct(scale_).norm(); }
  // Largest displacement of a body, its surface or a wall (m).
  double length_of(const Vector& motion) const;

  const Simulation& simulation_;
  double tolerance_;
  WallEquations walls_at_start_;
  DegreesOfFreedom freedom_;
  StaticContacts contacts_;
  StiffnessFactors factors_;                 // kept from earlier searches as long as steps converge fast
  std::vector<BodyForceTerms> body_forces_;  // empty if there are none at rest
  std::vector<Vec3> at_start_;               // (m) bodies and walls
  // 1 for forces, 1/R for torques: makes torques forces; rotations divided by it are lengths.
  Vector scale_;
  double smallest_radius_, moved_ = 0;  // (m) since pairs were searched for
  std::size_t iterations_ = 0;
};

}  // namespace scree::response
