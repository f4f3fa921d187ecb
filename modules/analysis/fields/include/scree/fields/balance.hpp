#pragma once

#include <vector>

#include <scree/fields/averaging_kernel.hpp>
#include <scree/fields/field_grid.hpp>
#include <scree/fields/field_input.hpp>
#include <scree/thread_pool.hpp>

namespace scree::fields {

// What a balance leaves open at the points of a grid, which is 0 but for round-off.
struct Balance {
  std::vector<Vec3> residual;  // of mass: only [0]
  double largest_term = 0;     // largest component of the terms of single bodies and contacts, at any point

  // Largest |component| over the largest term; 0 without terms.
  double relative() const;
};

// The straight path (m) of a body between two times, as if it crossed no periodic face.
Vec3 path_between(const FieldBody& first, const FieldBody& second, const Domain& domain);

// Of mass between two times (kg/m³):
//   ρ(t₂) − ρ(t₁) + ∇·∫J dt,   ∫J dt = Σ m d ∫₀¹ φ(x − x(t₁) − s d) ds
// with the path d of each body, see path_between(). Throws Error if the bodies or the periods
// of the inputs differ.
Balance mass_balance(const FieldInput& first, const FieldInput& second, const FieldGrid& grid,
                     const AveragingKernel& kernel, ThreadPool& threads);

// Of momentum over one step h (s) of velocity Verlet (kg/(m² s)), with means of the values before and after
// the step, written <>:
//   p₂ − p₁ + ∇·(h <σ> + Σ m <v> ⊗ d ∫φ ds) − h <t> − Σ (h <b + g> + H) <φ>
// σ: contact stress, t: traction of walls, b, g: body force and load of a group, H: impulse of what holds a
// body, m (v₂ − v₁) − h <F> for held components and 0 for others. Forces <f> act along the lines of their
// contacts before and after the step. Of free bodies it shows that v₂ − v₁ comes from the forces counted.
// Throws Error as mass_balance().
Balance momentum_balance(const FieldInput& first, const FieldInput& second, double step,
                         const FieldGrid& grid, const AveragingKernel& kernel, ThreadPool& threads);

}  // namespace scree::fields
