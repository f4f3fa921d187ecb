#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <scree/column.hpp>
#include <scree/vec.hpp>

namespace scree {

// One body as a scene states it; in 2D z components and the x, y spins are 0.
struct Body {
  std::int64_t id = 0;
  std::uint32_t material = 0;
  double radius = 0;   // (m)
  double mass = 0;     // (kg)
  double inertia = 0;  // (kg m²)
  Vec3 position = {};  // (m)
  Vec3 velocity = {};  // (m/s)
  Vec3 spin = {};      // (rad/s)
};

// Storage of all bodies, a column per property. Axes and spins that the scene does not need are not
// allocated.
class Particles {
 public:
  // Columns that a vector or a spin occupies: [first, last).
  struct Axes {
    int first, last;
  };

  Particles(int dimension, bool with_spin, bool with_images, const std::vector<Body>& bodies);

  std::size_t size() const { return radius.size(); }
  int dimension() const { return dimension_; }
  bool has_spin() const { return has_spin_; }
  Axes axes() const { return {0, dimension_}; }
  // 2D spins turn about z; none in a scene without spin.
  Axes spin_axes() const { return has_spin_ ? Axes{dimension_ == 2 ? 2 : 0, 3} : Axes{0, 0}; }
  Body body(std::size_t i) const;
  std::size_t bytes_per_body() const;

  // State, written by the integrator.
  Column<double> position[3];     // (m)
  Column<double> velocity[3];     // (m/s) after a step; while forces are evaluated, predicted for its end
  Column<double> spin[3];         // (rad/s) likewise
  Column<std::int32_t> image[3];  // times a body crossed a periodic face, if any axis is periodic

  // Within a step, written by the integrator: velocity at mid-step, displacement / step.
  Column<double> mid_velocity[3];
  Column<double> mid_spin[3];

  // Written by the force evaluation.
  Column<double> force[3];   // (N)
  Column<double> torque[3];  // (N m)

  // Constant.
  Column<double> radius, mass, inverse_mass, inertia, inverse_inertia;
  Column<std::int64_t> id;
  Column<std::uint32_t> material;

 private:
  int dimension_;
  bool has_spin_;
};

}  // namespace scree
