#pragma once

#include "vector.hpp"

#include <limits>
#include <optional>
#include <variant>
#include <vector>

// The contact laws of granular matter in continuous time: one impact of two bodies, or of a body on a wall,
// integrated to nearly the rounding of doubles. It shares no code with scree, whose kernels are compared with
// it. Any consistent units.
namespace reference {

enum class LawKind { linear, hertz };
// Whether the normal force may pull while the bodies overlap, or is cut off at zero.
enum class Tension { allowed, cut };
// What becomes of the tangential spring of the hertz law as its stiffness follows the overlap:
// displacement: it keeps its stretch; rescaled: it keeps its force while the overlap grows and its stretch
// while it falls; potential: it keeps its stretch, and its energy pushes the bodies apart.
enum class History { displacement, rescaled, potential };
// What slips at the Coulomb limit. spring: the spring when its own force reaches the limit; total: the spring
// so that spring and dashpot together stay at the limit (David et al. 2005; linear law only).
enum class SlipRule { spring, total };

struct Law {
  LawKind kind = LawKind::linear;
  Tension tension = Tension::cut;
  // Of a head-on impact; sets the normal damping (hertz: and the tangential). Without it the hertz law has
  // none.
  std::optional<double> restitution;
  double friction = 0;                     // may be infinite
  std::optional<double> dynamic_friction;  // of what slides; the same without it

  // The linear law alone.
  double normal_stiffness = 0;
  double normal_damping = 0;  // used without restitution
  double tangential_stiffness = 0;
  double tangential_damping = 0;
  SlipRule slip_rule = SlipRule::spring;

  // The hertz law alone. What b or the wall is made of, if not of the same as a.
  double youngs_modulus = 0;
  double poissons_ratio = 0;
  std::optional<double> other_youngs_modulus;
  std::optional<double> other_poissons_ratio;
  History history = History::rescaled;
};

// A sphere, or in two dimensions a disc that stays in the plane z = 0 and spins about z.
struct Body {
  int dimension = 3;
  double radius = 0;
  double mass = 0;
  Vector position;
  Vector velocity;
  Vector spin;

  double inertia() const { return (dimension == 2 ? 0.5 : 0.4) * mass * radius * radius; }
};

// A fixed plane; the normal points to the side of the bodies and need not have the length one.
struct Wall {
  Vector point;
  Vector normal;
};

struct Impact {
  Law law;
  Body a;
  std::variant<Body, Wall> other;
  // Rising times, from that of the given positions on, at which to sample the motion.
  std::vector<double> sample_times = {};
  // While the Coulomb limit is so low that a lag of the sliding direction behind the velocity changes no
  // impulse by more than about this part of the whole, the direction is that of the velocity: its own
  // equation is stiff there.
  double relaxed_limit = 1e-13;
};

// The motion at one time.
struct Sample {
  double time = 0;
  Body a;
  std::variant<Body, Wall> other;
  double overlap = 0;  // negative before and after the contact: minus the gap
  Vector spring;       // its stretch
  Vector force;        // on a
  bool sliding = false;
};

// Energies turned into heat, all from the first touch to the end of the contact; see `created`.
struct Dissipation {
  double normal = 0;      // by the normal dashpot, and what `cut` keeps from pulling back
  double tangential = 0;  // by the tangential dashpot
  double friction = 0;    // by the slip of the spring; with SlipRule::total it can be negative
  double release = 0;     // let go by the spring as its stiffness changes or the contact opens
};

struct Outcome {
  bool touched = false;  // if not, the rest is zero but for samples
  Body a;                // at the end of the contact
  std::variant<Body, Wall> other;
  double first_touch = 0;  // time
  double contact_time = 0;
  double pushing_time =
      0;  // the part of the contact time during which the normal force of the law was positive
  double largest_overlap = 0;
  double normal_impulse = 0;  // on a, the integral of the whole normal force along the normal as it turns
  Vector tangential_impulse;  // on a
  Dissipation dissipated;
  double created = 0;            // energy that the displacement history makes
  double remaining_elastic = 0;  // of the springs at the end of the contact, already counted as release:
                                 // rounding only, but for infinite friction and SlipRule::total
  int slides = 0;                // beginnings of sliding, one at first touch included
  int switches = 0;              // from stick to slide and back
  double energy_residual = 0;    // largest lack of balance during the contact, over the first kinetic energy
  int steps = 0;                 // of the integration
  std::vector<Sample> samples;
};

// Follows the impact until the bodies part. The tolerance is relative: of the local error of a step. Throws
// std::invalid_argument where the impact is ill-posed (overlapping bodies, damping with which they never
// part) and std::runtime_error if it does not end.
Outcome integrate(const Impact& impact, double tolerance = 1e-11);

}  // namespace reference
