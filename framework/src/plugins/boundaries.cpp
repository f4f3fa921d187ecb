#include "plugins/boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/state_hash.hpp>

namespace scree {

Boundaries::Boundaries(const std::vector<Scene::Boundary>& entries, int dimension, const BodyBounds& bodies)
    : dimension_(dimension) {
  for (int k = 0; k < 3; ++k) lower_[k] = bodies.lower[k], upper_[k] = bodies.upper[k];
  for (const Scene::Boundary& entry : entries) {
    members_.push_back(
        {entry, ConfiguredBoundary(entry.parameters, dimension, lower_, upper_), planes_.size()});
    Member& member = members_.back();
    const scree_boundary_instance& instance = member.plugin.instance();
    add_domain(member);
    member.state.assign(instance.state_width, 0.0);
    for (std::uint32_t k = 0; k < instance.plane_count; ++k) {
      names_.push_back(instance.plane_names ? fmt::format("{}.{}", entry.name, instance.plane_names[k])
                                            : entry.name);
      materials_.push_back(entry.material);
      masses_.push_back(instance.plane_masses ? instance.plane_masses[k] : 0);
    }
    planes_.resize(planes_.size() + instance.plane_count);
    loads_.resize(planes_.size());
    const scree_boundary_step start = step_of(member, 0, 0);
    member.plugin.interface().start(member.plugin.storage(), &start);
  }
  for (std::size_t w = 0; w < planes_.size(); ++w)
    for (int k = 0; k < dimension_; ++k)
      if (domain_.periodic[k] && std::abs(planes_[w].normal[k]) > 1e-12)
        throw Error(
            fmt::format("wall {} is normal to {}, which is a periodic axis: bodies would re-enter behind it; "
                        "remove one of the two",
                        names_[w], "xyz"[k]));
}

void Boundaries::add_domain(const Member& member) {
  const scree_boundary_instance& instance = member.plugin.instance();
  for (int k = 0; k < dimension_; ++k) {
    if (!instance.periodic[k]) continue;
    if (domain_.periodic[k])
      throw Error(fmt::format("boundary '{}': axis {} is already periodic; give each axis once",
                              member.entry.name, "xyz"[k]));
    domain_.periodic[k] = true;
    domain_.lower[k] = instance.lower[k];
    domain_.upper[k] = instance.upper[k];
  }
}

scree_boundary_step Boundaries::step_of(Member& member, double time, double step) {
  scree_boundary_step s = {};
  s.struct_size = sizeof(s);
  s.dimension = std::uint32_t(dimension_);
  s.time = time - member.clock_start;
  s.step = step;
  s.loads = loads_.data() + member.first_plane;
  s.planes = planes_.data() + member.first_plane;
  s.state = member.state.data();
  s.energy = &member.energy;
  return s;
}

void Boundaries::begin_step(double time, double step) {
  for (Member& member : members_) {
    if (member.still()) continue;
    const scree_boundary_step s = step_of(member, time, step);
    member.plugin.interface().begin_step(member.plugin.storage(), &s);
  }
}

void Boundaries::finish_step(double time, double step) {
  for (Member& member : members_)
    if (!member.still()) finish_step(member, time, step);
}

void Boundaries::finish_step(Member& member, double time, double step) {
  const scree_boundary_step s = step_of(member, time, step);
  member.plugin.interface().finish_step(member.plugin.storage(), &s);
}

void Boundaries::stop_planes(Member& member) {
  for (std::uint32_t k = 0; k < member.plugin.instance().plane_count; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      scree_plane& plane = planes_[member.first_plane + k];
      plane.velocity[axis] = plane.mid_velocity[axis] = 0;
    }
}

void Boundaries::extrapolate(double time) {
  planes_before_extrapolation_ = planes_;
  for (scree_plane& plane : planes_)
    for (int k = 0; k < 3; ++k) plane.point[k] += time * plane.velocity[k];
}

void Boundaries::reconfigure(const std::string& name, const Parameters& parameters, double time) {
  for (Member& member : members_) {
    if (member.entry.name != name) continue;
    ConfiguredBoundary changed(parameters, dimension_, lower_, upper_);
    if (changed.instance().plane_count != member.plugin.instance().plane_count ||
        changed.instance().state_width != member.plugin.instance().state_width)
      throw Error(fmt::format(
          "boundary '{}': these parameters change its number of walls, which must be the same in all stages",
          name));
    if (member.still()) finish_step(member, time, 0);
    member.plugin = std::move(changed);
    for (std::uint32_t k = 0; k < member.plugin.instance().plane_count; ++k)
      masses_[member.first_plane + k] =
          member.plugin.instance().plane_masses ? member.plugin.instance().plane_masses[k] : 0;
    member.clock_start = time;
    if (member.still()) stop_planes(member), finish_step(member, time, 0);
    return;
  }
  throw Error(fmt::format("no boundary '{}'", name));
}

double Boundaries::largest_damping_rate() const {
  double largest = 0;
  for (const Member& member : members_) largest = std::max(largest, member.plugin.instance().damping_rate);
  return largest;
}

scree_boundary_energy Boundaries::energy() const {
  scree_boundary_energy sum = {};
  for (const Member& member : members_) {
    sum.kinetic += member.energy.kinetic;
    sum.work += member.energy.work;
    sum.dissipated += member.energy.dissipated;
  }
  return sum;
}

double Boundaries::largest_speed() const {
  double largest = 0;
  for (const Member& member : members_) {
    if (member.still()) continue;
    for (std::uint32_t w = 0; w < member.plugin.instance().plane_count; ++w) {
      const scree_plane& plane = planes_[member.first_plane + w];
      double speed = 0;
      for (int k = 0; k < dimension_; ++k) speed += plane.mid_velocity[k] * plane.normal[k];
      if (!std::isfinite(speed)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, std::abs(speed));
    }
  }
  return largest;
}

void Boundaries::add_to_hash(StateHash& hash) const {
  for (const Member& member : members_) hash.add(member.state.data(), member.state.size());
  for (const scree_plane& plane : planes_) hash.add(plane.point, 3), hash.add(plane.velocity, 3);
}

Boundaries boundaries_of(const Scene& scene) {
  return Boundaries(scene.boundaries, scene.dimension, bounds_of(scene.bodies, scene.dimension));
}

}  // namespace scree
