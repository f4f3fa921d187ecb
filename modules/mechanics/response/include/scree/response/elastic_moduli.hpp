#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <scree/response/linear_system.hpp>

namespace scree::response {

// Two parallel walls across an axis between which a packing is periodic along the others.
struct WallPair {
  std::size_t low, high;  // walls
  int axis;
  double distance;  // (m)
  double area;      // (m²) of one period; in 2D a length (m)
};

// Throws Error if the simulation does not have two such walls and periodic axes.
WallPair wall_pair(const Simulation& simulation);

// Stresses per strain caused by a small displacement of a wall; the strain is the displacement over the
// distance of the walls. In 3D (Pa), in 2D (N/m).
struct StrainResponse {
  int axis;        // along which the wall moves
  double modulus;  // stress on that wall along the axis
  // The same with the strain of the middle half of the packing, between the medians of its outer quarters;
  // NaN if no bodies are there.
  double middle_modulus;
  std::vector<double>
      virial;       // normal stress along each axis, mean over the packing, from forces and branch vectors
  double balance;   // |sum of the forces on both walls|/|force on one of them|
  double residual;  // of K q = f
};

struct ElasticModuli {
  WallPair walls;
  StrainResponse compression;         // along the normal: the oedometric modulus
  std::vector<StrainResponse> shear;  // along each other axis: shear moduli
  std::size_t rattlers;

  // Constants of an isotropic solid with the means of these moduli; in 2D of a plane solid.
  double youngs_modulus() const, poissons_ratio() const, shear_modulus() const;
  // The ratio of lateral to normal stress in compression, K_0 = ν/(1 − ν), in 2D K_0 = ν, gives another ν.
  double lateral_ratio() const, poissons_ratio_by_lateral_ratio() const;
};

// Displaces the upper wall and holds the lower one, even if forces move them. Throws Error as wall_pair() and
// assemble() do, if the strain drives a floppy mode, so that there is no static response, or (interrupted) if
// `proceed` returns false.
ElasticModuli elastic_moduli(
    const Simulation& simulation, const AssemblyOptions& options = {},
    const std::function<bool()>& proceed = [] { return true; });

}  // namespace scree::response
