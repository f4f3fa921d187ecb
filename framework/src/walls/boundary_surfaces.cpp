#include "walls/boundary_surfaces.hpp"

#include "surfaces/nearest_point.hpp"
#include "surfaces/triangle_mesh.hpp"
#include "walls/boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/plugin/rotation.hpp>

namespace scree {

namespace {

constexpr scree_frame at_origin = {{0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};

double length(const double (&v)[3]) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

// Largest speed (m/s) with which a surface comes to where it was not: a turn about its own axis leaves it.
double speed_of(const WallSurfaces& all, std::size_t s, int dimension, double reach) {
  const scree_surface& surface = all.shapes[s];
  const scree_frame& frame = all.frames[s];
  const auto& q = frame.orientation;
  const Vec3 axis = Rotation{q[0], {{q[1], q[2], q[3]}}}(Vec3{{0, 0, 1}});
  Vec3 swing = {{frame.mid_spin[0], frame.mid_spin[1], frame.mid_spin[2]}};
  if (turns_into_itself(surface, dimension)) swing -= dot(swing, axis) * axis;
  const double farthest = all.meshes[s] ? all.meshes[s]->reach() : reach_of(surface, dimension);
  const double turning = norm(swing), moving = length(frame.mid_velocity);
  return turning > 0 ? moving + turning * std::min(reach, farthest) : moving;
}

}  // namespace

bool same_surfaces(const scree_boundary_instance& one, const scree_boundary_instance& other) {
  return one.surface_count == other.surface_count &&
         std::equal(one.surfaces, one.surfaces + one.surface_count, other.surfaces,
                    [](const scree_surface& a, const scree_surface& b) {
                      return a.shape == b.shape && a.side == b.side && a.mesh_size == b.mesh_size &&
                             std::equal(std::begin(a.size), std::end(a.size), b.size) &&
                             std::equal(a.mesh, a.mesh + a.mesh_size, b.mesh);
                    });
}

namespace {

// Its triangles; null if it is no mesh.
std::shared_ptr<const TriangleMesh> mesh_of(const scree_surface& surface, const char* plugin,
                                            const std::string& name) {
  if (surface.shape != SCREE_MESH) return nullptr;
  const auto refuse = [&](const std::string& problem, const char* cure) {
    throw Error(fmt::format("boundary plug-in {}, surface {}: {}; {}", plugin, name, problem, cure));
  };
  std::shared_ptr<const TriangleMesh> mesh;
  try {
    mesh = shared_mesh({surface.mesh, surface.mesh_size}, surface.size[0]);
  } catch (const Error& error) {
    refuse(error.problem(), "give a file with triangles");
  }
  if (surface.side != SCREE_BOTH_SIDES && !mesh->findings().closed())
    refuse("side is given, and the mesh is not closed: " + mesh->findings().text(),
           "close it, or leave side out: bodies then touch it from both sides");
  if (surface.side != SCREE_BOTH_SIDES && mesh->findings().nested)
    refuse("side is given, and the mesh has shells within shells",
           "give each shell as a boundary of its own");
  return mesh;
}

}  // namespace

void Boundaries::list_surfaces(const Member& member) {
  const scree_boundary_instance& instance = member.plugin.instance();
  for (std::uint32_t k = 0; k < instance.surface_count; ++k) {
    const std::string name = instance.surface_names
                                 ? fmt::format("{}.{}", member.entry.name, instance.surface_names[k])
                                 : member.entry.name;
    if (const char* const problem = problem_of(instance.surfaces[k], dimension_); *problem)
      throw Error(fmt::format("boundary plug-in {}, surface {}: {}; correct its parameters, or the plug-in",
                              member.plugin_name(), name, problem));
    surfaces_.shapes.push_back(instance.surfaces[k]);
    surfaces_.meshes.push_back(mesh_of(instance.surfaces[k], member.plugin_name(), name));
    surfaces_.materials.push_back(member.entry.material);
    surfaces_.names.push_back(name);
  }
  surfaces_.frames.resize(surfaces_.size(), at_origin);
  surfaces_.loads.resize(surfaces_.size());
}

std::vector<std::uint32_t> Boundaries::wall_materials() const {
  std::vector<std::uint32_t> all = materials_;
  all.insert(all.end(), surfaces_.materials.begin(), surfaces_.materials.end());
  return all;
}

const std::string& Boundaries::wall_name(std::size_t wall) const {
  return wall < names_.size() ? names_[wall] : surfaces_.names[wall - names_.size()];
}

std::span<scree_frame> Boundaries::frames_of(const Member& member) {
  return {surfaces_.frames.data() + member.first_surface, member.plugin.instance().surface_count};
}

void Boundaries::check_frames(const Member& member, const std::string& when, ExitStatus status) const {
  for (std::uint32_t k = 0; k < member.plugin.instance().surface_count; ++k)
    if (const std::string problem = problem_of(surfaces_.frames[member.first_surface + k]); !problem.empty())
      throw Error(fmt::format("boundary plug-in {}, surface {}: {} {}", member.plugin_name(),
                              surfaces_.names[member.first_surface + k], problem, when),
                  status);
}

double Boundaries::surface_speed(std::size_t surface, std::span<const double> reach) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double speed =
      speed_of(surfaces_, surface, dimension_, surface < reach.size() ? reach[surface] : infinite);
  return std::isfinite(speed) ? speed : infinite;
}

double Boundaries::largest_surface_speed(std::span<const double> reach) const {
  double largest = 0;
  for (const Member& member : members_) {
    if (member.still()) continue;
    for (std::uint32_t k = 0; k < member.plugin.instance().surface_count; ++k)
      largest = std::max(largest, surface_speed(member.first_surface + k, reach));
  }
  return largest;
}

void Boundaries::extrapolate(double time) {
  planes_before_extrapolation_ = planes_;
  for (scree_plane& plane : planes_)
    for (int k = 0; k < 3; ++k) plane.point[k] += time * plane.velocity[k];
  frames_before_extrapolation_ = surfaces_.frames;
  for (scree_frame& frame : surfaces_.frames) {
    auto& q = frame.orientation;
    const Vec3 turn = time * Vec3{{frame.spin[0], frame.spin[1], frame.spin[2]}};
    const Rotation turned = Rotation::by(turn) * Rotation{q[0], {{q[1], q[2], q[3]}}};
    for (int k = 0; k < 3; ++k) {
      frame.position[k] += time * frame.velocity[k];
      q[k + 1] = turned.axis[k];
    }
    q[0] = turned.real;
  }
}

void Boundaries::undo_extrapolation() {
  planes_ = planes_before_extrapolation_;
  surfaces_.frames = frames_before_extrapolation_;
}

}  // namespace scree
