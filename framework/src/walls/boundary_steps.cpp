#include "walls/boundaries.hpp"
#include "walls/boundary_checks.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree {

namespace {

// The planes of one boundary, which asks for their loads.
struct PlaneLoads {
  const Boundaries::LoadAfter& load_after;
  std::size_t first_plane;

  static void load(void* host, std::uint32_t plane, const double* displacement, scree_load* load) {
    const PlaneLoads& planes = *static_cast<const PlaneLoads*>(host);
    *load = planes.load_after(planes.first_plane + plane, displacement);
  }
};

}  // namespace

void Boundaries::begin_step(double time, double step, const LoadAfter& load_after) {
  for (Member& member : members_) {
    if (member.still()) continue;
    scree_boundary_energy energy = {};
    scree_boundary_step s = step_of(member, time, step, energy);
    PlaneLoads host = {load_after, member.first_plane};
    const scree_displaced_loads displaced_loads = {sizeof(displaced_loads), &host, &PlaneLoads::load};
    if (member.plugin.instance().displacement_speed > 0) s.displaced_loads = &displaced_loads;
    member.plugin.interface().begin_step(member.plugin.storage(), &s);
    add_energy(member, energy);
    check_finite(member, time + step);
  }
}

void Boundaries::finish_step(double time, double step) {
  for (Member& member : members_) {
    if (member.still()) continue;
    scree_boundary_energy energy = {};
    const scree_boundary_step s = step_of(member, time, step, energy);
    member.plugin.interface().finish_step(member.plugin.storage(), &s);
    member.energy.kinetic = energy.kinetic;
    add_energy(member, energy);
    check_finite(member, time + step);
  }
}

void Boundaries::add_energy(Member& member, const scree_boundary_energy& energy) {
  member.energy.work += energy.work;
  member.energy.dissipated += energy.dissipated;
}

void Boundaries::check_finite(const Member& member, double time) {
  for (const scree_plane& plane : planes_of(member))
    if (!is_finite(plane))
      throw Error(fmt::format("boundary plug-in {}, wall {}", member.plugin_name(),
                              names_[std::size_t(&plane - planes_.data())]),
                  fmt::format("{} at t = {:g} s", problem_of(plane), time),
                  "give it more mass or viscosity, or a shorter time.step", ExitStatus::blow_up);
  check_frames(member,
               fmt::format("at t = {:g} s; give it more mass or viscosity, or a shorter time.step", time),
               ExitStatus::blow_up);
}

}  // namespace scree
