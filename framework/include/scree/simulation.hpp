#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <scree/body_range.hpp>
#include <scree/body_terms.hpp>
#include <scree/boundaries.hpp>
#include <scree/contact_list.hpp>
#include <scree/contacts.hpp>
#include <scree/energy_audit.hpp>
#include <scree/forces.hpp>
#include <scree/integrator.hpp>
#include <scree/momentum_audit.hpp>
#include <scree/neighbour_list.hpp>
#include <scree/profile.hpp>
#include <scree/scene.hpp>

namespace scree {

// What a scene carries, for people to see that it pays for nothing else.
struct Footprint {
  std::size_t degrees_of_freedom, bytes_per_body, bytes_per_pair;
  std::uint32_t history_width;
};

// One scene in motion: neighbours -> contacts -> laws -> forces, boundaries, integrator, in this order each
// step.
class Simulation {
 public:
  // Sets everything up and evaluates the forces at t = 0. Throws Error for a scene that cannot be.
  explicit Simulation(const Scene& scene);

  // Advances by one time step. Throws Error(blow_up) naming particle, contact, time and cure.
  void step();
  // The same for up to so many steps: faster, for nobody looks at the bodies in between. In the course of
  // each step asks whether another may follow. Returns how many were made.
  std::uint64_t run(std::uint64_t steps, const std::function<bool()>& proceed);

  // Tells where the time of steps goes from now on; null ends it. The profile must live as long.
  void measure(Profile* profile) { profile_ = profile; }

  // New parameters for a law, boundary or body term by name, between steps; histories and walls stay.
  void reconfigure_law(const std::string& name, const Parameters& parameters);
  void reconfigure_boundary(const std::string& name, const Parameters& parameters);
  void reconfigure_body_term(const std::string& name, const Parameters& parameters);
  // To be called after reconfigurations, before the next step.
  void apply_reconfiguration();

  int dimension() const { return scene_.dimension; }
  double time() const { return time_; }               // (s)
  double step_length() const { return scene_.step; }  // (s)
  std::uint64_t steps() const { return steps_; }
  const Particles& particles() const { return particles_; }
  const Boundaries& boundaries() const { return boundaries_; }
  const BodyTerms& body_terms() const { return body_terms_; }
  const Contacts& contacts() const { return contacts_; }
  const Scene& scene() const { return scene_; }
  ContactList contact_list() const;

  scree_energy energy() const;
  // |residual| over the turnover of energy; 0 without an audit.
  double energy_residual() const;
  // Energy that contact laws have made, over the turnover; 0 without an audit.
  double energy_created() const;
  // Momentum made by the contact handling, which pairs and planes must cancel, over the momentum exchanged.
  double momentum_residual() const { return momentum_audit_.residual(); }
  double max_overlap_ratio() const { return contact_sums_.max_overlap_ratio; }
  std::uint64_t rebuilds() const { return neighbours_.rebuilds(); }
  double skin() const { return neighbours_.skin(); }
  // That of the first search (m): stated, or a tenth of the mean radius.
  double first_skin() const { return neighbours_.first_skin(); }
  // Shortest contact of the lightest pair of each law over the step, at the speeds expected or met so far,
  // whichever are higher; infinite without pairs.
  double min_steps_per_contact() const;
  std::uint64_t state_hash() const;
  Footprint footprint() const;

 private:
  Contacts make_contacts() const;
  Contacts::Lookup lookup() const;
  void configure_laws();
  // What moves bodies after an evaluation: the rest of this substep, and the first half of the next unless
  // somebody looks at them before (s).
  struct Moves {
    std::optional<double> kick = std::nullopt, drift = std::nullopt;
  };
  void drift_bodies(double step);
  // What the bodies of a part do once contacts have loaded them.
  void settle(std::size_t part, const Moves& moves, Profile* profile);
  // Forces on bodies where they are, after `step` since the last evaluation. Whether velocities and spins are
  // numbers then.
  bool evaluate_forces(double step, const Moves& moves);
  // The same where the bodies have not drifted.
  void evaluate_forces_afresh(double step);
  // One step; the next follows unseen.
  void step(bool more);
  // Moves everything by one substep, and bodies into the next; largest squared speed on the way (m²/s²),
  // infinite if any velocity or spin is not a number.
  double advance(double step, std::optional<double> next);
  // Brings forces and springs to where the bodies are, after an integrator that evaluates in mid-step.
  void catch_up();
  // Of the bodies as the scene states them (m²/s²).
  double largest_square_speed() const;
  bool too_fast(double square_speed) const;
  bool too_deep() const;
  // Whether an overlap may be beyond the limit once nobody has moved further than `way` (m).
  bool may_be_too_deep(double way) const;
  void check_health(double largest_square_speed) const;

  Scene scene_;
  std::vector<ConfiguredLaw> configured_laws_;
  std::vector<LawInstance> laws_;
  Boundaries boundaries_;
  BodyTerms body_terms_;
  Particles particles_;
  Contacts contacts_;
  NeighbourList neighbours_;
  Forces forces_;
  std::unique_ptr<Integrator> integrator_;
  std::unique_ptr<ThreadPool> threads_;
  Profile* profile_ = nullptr;

  double time_ = 0;
  double force_time_ = 0;  // (s) at which forces were evaluated last
  std::uint64_t steps_ = 0;
  ContactSums contact_sums_;
  BodySums body_sums_;
  EnergyAudit audit_;
  MomentumAudit momentum_audit_;
  double max_square_speed_ = 0;  // (m²/s²)
  double smallest_radius_ = 0;   // (m)
  double speed_limit_ = 0;

  // What the bodies of each part add up to.
  struct PartSums {
    BodySums bodies;
    MomentumAudit::Sums momentum;
    double square_speed = 0;
    bool finite = true;
  };
  bool drifted_ = false;  // bodies have drifted into the next substep
  BodyTiles tiles_;
  std::vector<PartSums> part_sums_;
};

}  // namespace scree
