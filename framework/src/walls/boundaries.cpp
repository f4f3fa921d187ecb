#include "walls/boundaries.hpp"

#include "plugins/plugin_call.hpp"
#include "walls/boundary_checks.hpp"
#include "walls/boundary_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/state_hash.hpp>

namespace scree {

Boundaries::Boundaries(const std::vector<Scene::Boundary>& entries, int dimension, const BodyBounds& bodies)
    : dimension_(dimension) {
  shared_.struct_size = sizeof(shared_);
  for (int k = 0; k < 3; ++k) {
    shared_.lower[k] = lower_[k] = bodies.lower[k];
    shared_.upper[k] = upper_[k] = bodies.upper[k];
  }
  for (const Scene::Boundary& entry : entries) add(entry);
  set_displacement_speed();
  check_walls_against_domain();
}

void Boundaries::add(const Scene::Boundary& entry) {
  members_.push_back({entry, ConfiguredBoundary(entry.parameters, dimension_, lower_, upper_), planes_.size(),
                      surfaces_.size()});
  Member& member = members_.back();
  check_layout(member.plugin_name(), member.plugin.instance(), dimension_);
  add_domain(member);
  list_planes(member);
  list_surfaces(member);
  show_walls();
  member.state.assign(member.plugin.instance().state_width, 0.0);
  start(member);
}

void Boundaries::list_planes(const Member& member) {
  const scree_boundary_instance& instance = member.plugin.instance();
  for (std::uint32_t k = 0; k < instance.plane_count; ++k) {
    names_.push_back(instance.plane_names ? fmt::format("{}.{}", member.entry.name, instance.plane_names[k])
                                          : member.entry.name);
    materials_.push_back(member.entry.material);
  }
  planes_.resize(names_.size());
  loads_.resize(names_.size());
  name_pointers_.clear();
  for (const std::string& name : names_) name_pointers_.push_back(name.c_str());
  shared_.plane_count = std::uint32_t(planes_.size());
  shared_.planes = planes_.data();
  shared_.loads = loads_.data();
  shared_.plane_names = name_pointers_.data();
}

void Boundaries::show_walls() {
  masses_.resize(planes_.size());
  surfaces_.masses.resize(surfaces_.size());
  surfaces_.absent.resize(surfaces_.size());
  absent_.resize(wall_count());
  for (const Member& member : members_) {
    const scree_boundary_instance& instance = member.plugin.instance();
    for (std::uint32_t k = 0; k < instance.plane_count; ++k) {
      masses_[member.first_plane + k] = instance.plane_masses ? instance.plane_masses[k] : 0;
      absent_[member.first_plane + k] = instance.plane_absent && instance.plane_absent[k];
    }
    for (std::size_t s = member.first_surface; s < member.first_surface + instance.surface_count; ++s) {
      surfaces_.masses[s] = instance.surface_mass;
      absent_[planes_.size() + s] = surfaces_.absent[s] = instance.surfaces_absent != 0;
    }
  }
}

void Boundaries::start(Member& member) {
  scree_boundary_energy energy = {};
  const scree_boundary_step step = step_of(member, 0, 0, energy);
  char message[512] = "";
  const int refused = plugin_call(member.plugin_name(), "start", [&] {
    return member.plugin.interface().start(member.plugin.storage(), &step, message, sizeof(message));
  });
  message[sizeof(message) - 1] = 0;
  if (refused)
    throw Error(fmt::format("{}: {}", member.plugin_name(), *message ? message : "refused to start"));
  member.energy.kinetic = energy.kinetic;
  add_energy(member, energy);
  for (const scree_plane& plane : planes_of(member))
    if (const std::string problem = problem_of(plane); !problem.empty())
      throw Error(
          fmt::format("boundary plug-in {}, wall {}: {} at the start; correct its parameters, or the plug-in",
                      member.plugin_name(), names_[std::size_t(&plane - planes_.data())], problem));
  check_frames(member, "at the start; correct its parameters, or the plug-in", ExitStatus::bad_input);
}

void Boundaries::check_walls_against_domain() const {
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
  show_domain();
}

void Boundaries::show_domain() {
  for (int k = 0; k < 3; ++k) {
    shared_.periodic[k] = domain_.periodic[std::size_t(k)];
    shared_.domain_lower[k] = domain_.lower[k];
    shared_.domain_upper[k] = domain_.upper[k];
  }
}

scree_boundary_step Boundaries::step_of(Member& member, double time, double step,
                                        scree_boundary_energy& energy) {
  scree_boundary_step s = step_of(member, planes_of(member), member.state, time, step, energy);
  s.frames = frames_of(member).data();
  return s;
}

scree_boundary_step Boundaries::step_of(const Member& member, std::span<scree_plane> planes,
                                        std::span<double> state, double time, double step,
                                        scree_boundary_energy& energy) const {
  scree_boundary_step s = {};
  s.struct_size = sizeof(s);
  s.dimension = std::uint32_t(dimension_);
  s.time = member.clock.at(time);
  s.step = step;
  s.plane_count = std::uint32_t(planes.size());
  s.state_width = std::uint32_t(state.size());
  s.loads = loads_.data() + member.first_plane;
  s.planes = planes.data();
  s.state = state.data();
  s.energy = &energy;
  s.scene = &shared_;
  s.surface_count = member.plugin.instance().surface_count;
  s.frame_loads = surfaces_.loads.data() + member.first_surface;
  return s;
}

std::span<scree_plane> Boundaries::planes_of(const Member& member) {
  return {planes_.data() + member.first_plane, member.plugin.instance().plane_count};
}

void Boundaries::reconfigure(const std::string& name, const Parameters& parameters, double time,
                             const std::vector<std::string>& going_on) {
  for (Member& member : members_) {
    if (member.entry.name != name) continue;
    Clock clock = member.clock;
    clock.restart(time, going_on);
    ConfiguredBoundary changed(clock.shown(parameters), dimension_, lower_, upper_);
    check_layout(member.plugin_name(), changed.instance(), dimension_);
    if (changed.instance().plane_count != member.plugin.instance().plane_count)
      throw Error(fmt::format(
          "boundary '{}': these parameters change its number of walls, which must be the same in all stages",
          name));
    if (!same_surfaces(changed.instance(), member.plugin.instance()))
      throw Error(fmt::format(
          "boundary '{}': these parameters change its surfaces, which must be the same in all stages, and as in a state; give a new boundary, or leave_out = [\"walls\"] in [particles] with a state",
          name));
    std::swap(member.plugin, changed);
    std::swap(member.clock, clock);
    member.entry.parameters = parameters;
    set_displacement_speed();
    change(member, changed, clock.at(time), time);
    return;
  }
  throw Error(fmt::format("no boundary '{}'", name));
}

void Boundaries::change(Member& member, const ConfiguredBoundary& before, double time_before, double time) {
  const scree_boundary_instance& instance = member.plugin.instance();
  show_walls();
  scree_boundary_energy energy = {};
  if (member.plugin.interface().change) {
    if (instance.state_width > member.state.size()) member.state.resize(instance.state_width, 0.0);
    const scree_boundary_step s = step_of(member, time, 0, energy);
    member.plugin.interface().change(member.plugin.storage(), before.storage(), time_before, &s);
  } else if (!member.still()) {
    energy.kinetic = member.energy.kinetic;
  }
  member.state.resize(instance.state_width, 0.0);
  if (member.still())
    for (scree_plane& plane : planes_of(member))
      for (int k = 0; k < 3; ++k) plane.velocity[k] = plane.mid_velocity[k] = 0;
  for (scree_frame& frame : frames_of(member))
    for (int k = 0; member.still() && k < 3; ++k)
      frame.velocity[k] = frame.mid_velocity[k] = frame.spin[k] = frame.mid_spin[k] = 0;
  energy.work += energy.kinetic - member.energy.kinetic;
  member.energy.kinetic = energy.kinetic;
  add_energy(member, energy);
  check_finite(member, time);
}

void Boundaries::set_displacement_speed() {
  displacement_speed_ = 0;
  for (const Member& member : members_)
    displacement_speed_ = std::max(displacement_speed_, member.plugin.instance().displacement_speed);
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
  for (const scree_frame& frame : surfaces_.frames) {
    for (const double* vector : {frame.position, frame.velocity, frame.spin}) hash.add(vector, 3);
    hash.add(frame.orientation, 4);
  }
}

Boundaries boundaries_of(const Scene& scene) {
  return Boundaries(scene.boundaries, scene.dimension, bounds_of(scene.bodies, scene.dimension));
}

namespace {

// Moves a point, and returns by how much.
Vec3 moved_to(const Vec3& place, double (&point)[3]) {
  Vec3 moved;
  for (int k = 0; k < 3; ++k) moved[k] = place[k] - point[k], point[k] = place[k];
  return moved;
}

}  // namespace

void Boundaries::come_to_rest(const RestingPacking& packing) {
  std::copy(packing.loads.begin(), packing.loads.end(), loads_.begin());
  std::copy(packing.surface_loads.begin(), packing.surface_loads.end(), surfaces_.loads.begin());
  std::vector<Vec3> displacements;  // (m) of all walls
  for (std::size_t w = 0; w < planes_.size(); ++w) {
    scree_plane& plane = planes_[w];
    displacements.push_back(moved_to(packing.planes[w], plane.point));
    for (int k = 0; k < 3; ++k) plane.velocity[k] = plane.mid_velocity[k] = 0;
  }
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    scree_frame& frame = surfaces_.frames[s];
    displacements.push_back(moved_to(packing.surfaces[s], frame.position));
    for (int k = 0; k < 3; ++k)
      frame.velocity[k] = frame.mid_velocity[k] = frame.spin[k] = frame.mid_spin[k] = 0;
  }
  for (Member& member : members_)
    if (member.plugin.interface().rest && !member.still()) come_to_rest(member, packing.time, displacements);
  // At rest extrapolation moves nothing.
  if (!planes_before_extrapolation_.empty()) planes_before_extrapolation_ = planes_;
  if (!frames_before_extrapolation_.empty()) frames_before_extrapolation_ = surfaces_.frames;
}

void Boundaries::come_to_rest(Member& member, double time, const std::vector<Vec3>& displacements) {
  const std::size_t planes = member.plugin.instance().plane_count,
                    surfaces = member.plugin.instance().surface_count;
  const auto own = std::make_unique<double[][3]>(planes + surfaces);
  for (std::size_t w = 0; w < planes + surfaces; ++w) {
    const std::size_t wall =
        w < planes ? member.first_plane + w : planes_.size() + member.first_surface + (w - planes);
    std::copy_n(displacements[wall].component, 3, own[w]);
  }
  scree_boundary_energy energy = {};
  const scree_boundary_step step = step_of(member, time, 0, energy);
  plugin_call(member.plugin_name(), "rest",
              [&] { member.plugin.interface().rest(member.plugin.storage(), &step, own.get()); });
  member.energy.kinetic = energy.kinetic;
}

}  // namespace scree
