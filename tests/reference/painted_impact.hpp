#pragma once

#include "impact.hpp"

namespace reference {

// An impact with a tangential spring between a point painted on each of both spheres, or on a sphere and a
// wall (dimension 3; the history and the slip rule of the law are not used): V = normal part + ½ k_t ξ², ξ =
// R_a log_C(A) − R_b log_n(B), C = −n; beside a wall the second part is the displacement along it. The bodies
// touch at the begin. Equal steps of the classical Runge-Kutta method, so many in the contact time without
// damping, and after each the slip to the Coulomb limit, half of it on either point: near the end of the
// contact of first order, elsewhere of second.
Outcome integrate_painted(const Impact& touching, int steps);

}  // namespace reference
