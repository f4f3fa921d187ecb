#pragma once

#include <span>
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
  // Adds what is open over the time that follows.
  void add(const Balance& next);
};

// The straight path (m) of a body between two times, as if it crossed no periodic face.
Vec3 path_between(const FieldBody& first, const FieldBody& second, const Domain& domain);

// Of mass between two times (kg/m³):
//   ρ(t₂) − ρ(t₁) + ∇·∫J dt,   ∫J dt = Σ m d ∫₀¹ φ(x − x(t₁) − s d) ds
// with the path d of each body, see path_between(). Throws Error if the bodies or the periods
// of the inputs differ.
Balance mass_balance(const FieldInput& first, const FieldInput& second, const FieldGrid& grid,
                     const AveragingKernel& kernel, ThreadPool& threads);

// The forces of one evaluation, listed at the end of its step, and for how long (s) they act in a step.
struct ForceShare {
  const FieldInput* input;
  double duration;
};

// How integrators put the step h (s) from t₁ to t₂ together, exactly: m (v₂ − v₁) = Σ h_k F_k.
//   velocity_verlet: h/2 (F₁ + F₂); each substep of fourth_order likewise, with its own length
//   position_verlet: h F, of the evaluation at mid-step, which is that of the input after the step
//   predictor_corrector: h/24 (9 F₂ + 19 F₁ − 5 F₀ + F₋₁), Adams and Moulton's formula, which Gear's
//     correction of five terms is: the matrix that carries its third and fourth derivatives from step to step,
//     [−1/2, 1; −1/4, 1/2], is nilpotent, so that they are known from three evaluations.
std::vector<ForceShare> verlet_shares(const FieldInput& before, const FieldInput& after, double step);
// last: at least four, the latest at the end.
std::vector<ForceShare> adams_moulton_shares(std::span<const FieldInput> last, double step);

// Of momentum between two times (kg/(m² s)), with means of the values at both written <>:
//   p₂ − p₁ + ∇·Σ m <v> ⊗ d ∫φ ds + Σ_k h_k (∇·<σ>_k − <t>_k − Σ (b + g)_k <φ>) − Σ H <φ>
// σ_k: stress of the contacts of evaluation k, each along the line between its bodies at either time, t:
// traction of walls, b, g: body force and load of a group, H: impulse of what holds a body, m (v₂ − v₁) − Σ
// h_k F_k for held components and 0 for others. Of free bodies it shows that v₂ − v₁ comes from the forces
// counted. Throws Error as mass_balance().
Balance momentum_balance(const FieldInput& first, const FieldInput& second,
                         std::span<const ForceShare> forces, const FieldGrid& grid,
                         const AveragingKernel& kernel, ThreadPool& threads);

}  // namespace scree::fields
