#pragma once

#include <string>
#include <vector>

#include <scree/body_group.hpp>
#include <scree/integration.hpp>
#include <scree/parameters.hpp>
#include <scree/particles.hpp>

namespace scree {

// Limits beyond which a run is stopped as a blow-up.
struct Limits {
  double overlap_ratio = 0.5;  // overlap / smaller radius of the pair
  double speed = 0;            // (m/s); 0: one smallest radius per step
};

// Everything needed to set up a simulation.
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
  // Tangential spring of a contact at the start: how far the contact point of body a (index) has moved
  // relative to b's while they stuck.
  struct Spring {
    std::uint32_t a, b;
    Vec3 displacement;  // (m)
  };

  int dimension = 3;
  double step = 0;  // (s)
  Integration integration = Integration::velocity_verlet;
  // (m/s) impact speed for which the time step is checked; 0: derived from the initial velocities
  double expected_speed = 0;
  double skin = 0;       // (m); 0: starts at a tenth of the mean radius and adapts to the motion
  unsigned threads = 1;  // upper limit; see min_bodies_per_thread
  // Each thread costs some microseconds per step, so that small scenes run faster on fewer threads.
  std::size_t min_bodies_per_thread = 500;
  bool audit = true;          // compute the energy balance
  bool pair_forces = true;    // store per-contact forces; needed by probes and snapshots that read contacts
  bool sliding_work = false;  // add up what friction dissipates on surfaces; needs the audit
  bool spin = false;          // carry spins even if no law needs them yet, because a later stage does
  bool orientations = false;  // carry orientations even if no law reads them, because a probe does
  Limits limits;
  std::vector<std::string> materials;
  std::vector<Body> bodies;
  std::vector<BodyGroup> groups;
  std::vector<BodySelection> selections;  // nothing in the motion depends on them
  std::vector<Spring> springs;            // of another code; contacts that are not listed begin without one
  std::vector<Law> laws;
  std::vector<std::uint32_t> law_of;  // (materials, materials), symmetric: index into laws
  std::vector<Boundary> boundaries;
  std::vector<BodyForce> body_forces;
};

// Whether a law with these parameters exerts torques, so that the scene must carry spins.
bool exerts_torque(const Parameters& law, int dimension);
// Whether it reads orientations, so that the scene must carry them.
bool depends_on_orientations(const Parameters& law, int dimension);

}  // namespace scree
