#pragma once

#include <array>
#include <vector>

#include <scree/fields/averaging_kernel.hpp>
#include <scree/fields/field_grid.hpp>
#include <scree/fields/field_input.hpp>
#include <scree/thread_pool.hpp>

namespace scree::fields {

// Row by row: component (i, j) at 3 i + j.
using Tensor = std::array<double, 9>;

// Fields at one point. In 2D discs are 1 m deep.
struct FieldPoint {
  double density = 0;          // (kg/m³) Σ m φ
  double solid_fraction = 0;   // Σ (volume of a body) φ
  Vec3 momentum = {};          // (kg/(m² s)) Σ m v φ
  Vec3 velocity = {};          // (m/s) momentum / density, 0 where there is no mass
  Tensor kinetic_stress = {};  // (Pa) Σ m (v − velocity) ⊗ (v − velocity) φ
  Tensor contact_stress = {};  // (Pa) Σ f ⊗ l ∫φ ds, above 0 in compression; not symmetric while spins change
  Vec3 stress_divergence = {};            // (N/m³) ∂σ_ij/∂x_j
  Vec3 traction = {};                     // (N/m³) Σ f φ(x − contact point), of walls on bodies
  Vec3 body_force = {}, group_load = {};  // (N/m³) of [[body_force]], of loads of groups
  // (N/m³) − Σ F φ over held components: what holds bodies, less mass times the acceleration that it gives.
  Vec3 holding_force = {};
  Vec3 net_force = {};      // (N/m³) Σ F φ, F: load of a body as the kernel adds it up
  double largest_term = 0;  // (N/m³) largest component of a single term of the balance of forces

  // (N/m³) What the balance of forces leaves open: 0 but for round-off if every contact was counted.
  Vec3 residual() const { return net_force + stress_divergence - traction - body_force - group_load; }
};

// Fields on a grid from one or more inputs; of several, the mean, with the kinetic stress about the mean
// velocity of all. The result has the same bits for any number of threads.
class FieldSums {
 public:
  FieldSums(const FieldGrid& grid, const AveragingKernel& kernel);

  // Throws Error if the input has another dimension than the grid, or other periods.
  void add(const FieldInput& input, ThreadPool& threads);
  std::size_t inputs() const { return inputs_; }
  const FieldGrid& grid() const { return grid_; }
  double mean_time() const { return inputs_ ? time_ / double(inputs_) : 0; }  // (s)
  // The means, in the order of the points of the grid.
  std::vector<FieldPoint> means() const;

 private:
  void add_body(const FieldBody& body, const GridSlab& slab);
  void add_contact(const FieldInput& input, const FieldContact& contact, const GridSlab& slab);

  FieldGrid grid_;
  AveragingKernel kernel_;
  std::vector<FieldPoint> points_;  // sums
  std::size_t inputs_ = 0;
  double time_ = 0;  // (s) sum
};

// Largest |component| of the residual of the balance of forces at any point, over the largest term anywhere.
double force_residual(const std::vector<FieldPoint>& points);

// Throws Error if an input does not fit a grid.
void check_input(const FieldGrid& grid, const FieldInput& input);

}  // namespace scree::fields
