#pragma once

#include <string>
#include <vector>

#include <scree/integration.hpp>
#include <scree/parameters.hpp>
#include <scree/particles.hpp>
#include <scree/precision.hpp>

namespace scree {

// Bounds beyond which a run is stopped as blown up.
struct Limits {
  double overlap_ratio = 0.5;  // of the smaller radius
  double speed = 0;            // (m/s), 0: one smallest radius per step
};

// Everything the kernel needs to know to set up a simulation.
struct Scene {
  struct Law {
    std::string name;  // unique; materials and stages refer to it
    Parameters parameters;
  };
  struct Boundary {
    std::string name;
    std::uint32_t material = 0;
    Parameters parameters;
  };
  struct BodyForce {
    std::string name;
    Parameters parameters;
  };

  int dimension = 3;
  double step = 0;  // (s)
  Integration integration = Integration::velocity_verlet;
  Precision precision = Precision::double_precision;
  double expected_speed =
      0;                 // (m/s) of impacts, for what the step is judged by; 0: from the bodies' at the start
  double skin = 0;       // (m), 0: at most a tenth of the mean radius, thinner where little moves
  unsigned threads = 1;  // at most; see least_bodies_per_thread
  // A thread costs some microseconds a step, so that small scenes run faster on fewer.
  std::size_t least_bodies_per_thread = 500;
  bool audit = true;        // keep the energy books
  bool pair_forces = true;  // keep the force of each contact for who looks at it
  bool spin = false;        // carry spins even if no law needs them now, because a later stage does
  Limits limits;
  std::vector<std::string> materials;
  std::vector<Body> bodies;
  std::vector<Law> laws;
  std::vector<std::uint32_t> law_of;  // (materials, materials), symmetric: index into laws
  std::vector<Boundary> boundaries;
  std::vector<BodyForce> body_forces;
};

// Whether a law with these parameters turns bodies, so that a scene must carry spins.
bool turns_bodies(const Parameters& law, int dimension);

}  // namespace scree
