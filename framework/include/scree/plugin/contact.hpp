#pragma once

#include <cstdint>
#include <type_traits>

#include <scree/plugin/abi.h>
#include <scree/plugin/roots.hpp>
#include <scree/plugin/vec.hpp>

// Input and output of a contact law for one touching pair.

namespace scree {

// Bits of `reads`, for the members of Contact.
inline constexpr std::uint32_t reads_normal = 1u << SCREE_NORMAL;
inline constexpr std::uint32_t reads_overlap = 1u << SCREE_OVERLAP;
inline constexpr std::uint32_t reads_relative_velocity = 1u << SCREE_RELATIVE_VELOCITY;
inline constexpr std::uint32_t reads_tangential_increment = 1u << SCREE_TANGENTIAL_INCREMENT;
inline constexpr std::uint32_t reads_relative_spin = 1u << SCREE_RELATIVE_SPIN;
inline constexpr std::uint32_t reads_onset_weight = 1u << SCREE_ONSET_WEIGHT;
inline constexpr std::uint32_t reads_contact_radius = 1u << SCREE_CONTACT_RADIUS;
inline constexpr std::uint32_t reads_reduced_mass = 1u << SCREE_REDUCED_MASS;
inline constexpr std::uint32_t reads_reduced_mass_root = 1u << SCREE_REDUCED_MASS_ROOT;
inline constexpr std::uint32_t reads_effective_radius = 1u << SCREE_EFFECTIVE_RADIUS;
inline constexpr std::uint32_t reads_orientations = 1u << SCREE_ORIENTATION_A | 1u << SCREE_ORIENTATION_B;
inline constexpr std::uint32_t reads_separation = 1u << SCREE_SEPARATION;
inline constexpr std::uint32_t reads_radii = 1u << SCREE_RADII;

// Type of an input that the kernel's `reads` does not list: any use of it fails to compile.
template <scree_contact_input column>
struct NotListedInReads {};

template <std::uint32_t reads, scree_contact_input column, class T>
using Input = std::conditional_t<(reads & (1u << column)) != 0, T, NotListedInReads<column>>;

// Input of a law: one touching pair. `reads` comes from the kernel; overlap, step and kick are always there.
template <int D, class T, std::uint32_t reads>
struct Contact {
  using Vector = Vec<D, T>;
  using Spin = Vec<spin_components<D>, T>;
  using Orientation = Vec<orientation_components<D>, T>;

  Input<reads, SCREE_NORMAL, Vector> normal;  // unit, from b to a
  T overlap;                                  // (m) > 0
  T step;                                     // (s) negative in a substep backwards in time
  T kick;                                     // (s) for which the force acts; 0: evaluated without motion
  bool backwards;                             // step < 0, of kernels with `follows_backwards`; else false
  bool onset;  // whether any pair of the batch has an onset weight but 1, of kernels with `follows_onset`
  bool at_surface;  // whether b is a surface, of kernels with `follows_surfaces`; else false
  // (m/s) of the contact points, a minus b, at the end of the step
  Input<reads, SCREE_RELATIVE_VELOCITY, Vector> relative_velocity;
  // (m) displacement of a's contact point relative to b's while touching in this step, perpendicular to the
  // mid-step normal
  Input<reads, SCREE_TANGENTIAL_INCREMENT, Vector> tangential_increment;
  Input<reads, SCREE_RELATIVE_SPIN, Spin> relative_spin;  // (rad/s) a minus b
  // Factor for forces that begin as t^onset_power at first touch.
  Input<reads, SCREE_ONSET_WEIGHT, T> onset_weight;
  // (m) a = √(R* δ) of a Hertzian contact, and 1/a
  Input<reads, SCREE_CONTACT_RADIUS, Root<T>> contact_radius;
  Input<reads, SCREE_CONTACT_RADIUS, T> contact_radius_root;   // (m^½) √a
  Input<reads, SCREE_REDUCED_MASS, T> reduced_mass;            // (kg)
  Input<reads, SCREE_REDUCED_MASS_ROOT, T> reduced_mass_root;  // (kg^½)
  Input<reads, SCREE_EFFECTIVE_RADIUS, T> effective_radius;    // (m)
  // In 2D the angle (rad) since the start, in 3D the unit quaternion (w, x, y, z) of the rotation since the
  // start; of a surface the orientation of its frame. A plane does not turn.
  Input<reads, SCREE_ORIENTATION_A, Orientation> orientation_a;
  Input<reads, SCREE_ORIENTATION_B, Orientation> orientation_b;
  // (m) x_a − x_b. Of a wall: of a and of the plane's point or the origin of the surface's frame, along a
  // path without periodic jumps.
  Input<reads, SCREE_SEPARATION, Vector> separation;
  Input<reads, SCREE_RADII, T> radius_a, radius_b;  // (m) of a wall 0
  // (1/m) xx, yy, zz, xy, xz, yz of the derivative of the normal with the place of a, if at_surface
  Vec<6, T> normal_change;
};

// Type of the couple of a kernel without `writes_couple`: any use of it fails to compile.
struct NotDeclaredByWritesCouple {};

// Output of a law. All members are initialised to 0.
template <int D, class T, bool writes_couple = false>
struct LawOutput {
  Vec<D, T> force;  // (N) on a, the opposite on b
  // (N m) on a in addition to arm × force, the opposite on b
  std::conditional_t<writes_couple, Vec<spin_components<D>, T>, NotDeclaredByWritesCouple> couple;
  T elastic_normal;               // (J) stored
  T elastic_tangential;           // (J) stored
  T dissipation_rate_normal;      // (W)
  T dissipation_rate_tangential;  // (W)
  T dissipation_rate_rolling;     // (W)
  T dissipated_friction;          // (J) during the step
  T dissipated_release;           // (J) during the step
};

// History of a law without memory.
template <int D, class T>
struct NoHistory {};

// Lower bound for divisors that may vanish; its reciprocal is finite.
template <class T>
inline constexpr T smallest_divisor = T(1e-300);

}  // namespace scree
