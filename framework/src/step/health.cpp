#include "step/health.hpp"

#include "plugins/program_checks.hpp"
#include "surfaces/placed_surface.hpp"
#include "walls/boundaries.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/step_guard.hpp>
#include <scree/told_apart.hpp>

namespace scree {

namespace {

std::string where(const Simulation& s) { return fmt::format("at t = {:g} s (step {})", s.time(), s.steps()); }

[[noreturn]] void stop(const std::string& place, const std::string& problem, const std::string& cure) {
  throw Error(place, problem, cure, ExitStatus::blow_up);
}

void report_not_a_number(const Simulation& s, const Body& body) {
  if (std::isfinite(norm(body.position)) && std::isfinite(norm(body.velocity)) &&
      std::isfinite(norm(body.spin)))
    return;
  stop(fmt::format("particle {}", body.id),
       fmt::format("position, velocity or spin is not a number {}", where(s)),
       fmt::format("use a shorter time.step (now {:g} s) or check for overlapping bodies at the start",
                   s.step_length()));
}

void report_speed(const Simulation& s, const std::string& what, double speed, double limit) {
  if (speed <= limit) return;
  const auto [shown, bound] = told_apart(speed, limit);
  stop("", fmt::format("{} moves at {} m/s {}, above the limit of {} m/s", what, shown, where(s), bound),
       fmt::format("use a shorter time.step (now {:g} s), or raise limits.speed if this speed is intended",
                   s.step_length()));
}

void report_overlap(const Simulation& s) {
  const ContactList list = s.contact_list();
  const Particles& p = s.particles();
  std::size_t worst = 0;
  double worst_ratio = 0;
  for (std::size_t c = 0; c < list.size(); ++c) {
    double radius = p.radius()[list.a[c]];
    if (list.b[c] < p.size()) radius = std::min(radius, p.radius()[list.b[c]]);
    if (list.overlap[c] / radius > worst_ratio) worst_ratio = list.overlap[c] / radius, worst = c;
  }
  if (!(worst_ratio > s.scene().limits.overlap_ratio)) return;
  const std::uint32_t b = list.b[worst];
  const std::string other =
      b < p.size() ? fmt::format("particle {}", p.id[b]) : fmt::format("wall {}", s.wall_name(b - p.size()));
  const bool unstable = s.step_length() > shortest_limit(s).longest_step;
  const char* cure = s.steps() > 0 && unstable ? "use a shorter time.step (it exceeds the stable step)"
                     : s.steps() > 0           ? "use a stiffer contact, a lower load or a shorter time.step"
                     : worst_ratio >= 2 && b < p.size() ? "their centres coincide: move them apart"
                                                        : "they overlap at the start: move them apart";
  const auto [shown, bound] = told_apart(worst_ratio, s.scene().limits.overlap_ratio, 3);
  stop(fmt::format("contact of particle {} with {}", p.id[list.a[worst]], other),
       fmt::format("overlap is {} of the smaller radius {}, above the limit of {}", shown, where(s), bound),
       fmt::format("{}, or raise limits.overlap_ratio", cure));
}

[[noreturn]] void refuse(const BodyGroup& group, int component, const std::string& problem,
                         const char* cure) {
  throw Error(fmt::format("group '{}', component {}: {}; {}", group.name, component, problem, cure));
}

// Functions of time are read unchecked, and only what is held follows one.
void check_groups(const Scene& scene) {
  std::vector<freedom::Mask> moved(scene.groups.empty() ? 0 : scene.bodies.size(), 0);
  for (const BodyGroup& group : scene.groups) {
    for (const std::uint32_t i : group.bodies)
      if (i >= scene.bodies.size())
        refuse(group, 0, "has a body that does not exist", "give indices of bodies");
    for (int k = 0; k < freedom::count; ++k) {
      const auto c = std::size_t(k);
      for (const auto* program : {&group.velocity[c], &group.displacement[c], &group.load[c]})
        if (const auto problem = program->empty() ? std::nullopt : program_problem(*program))
          refuse(group, k, problem->what(), "correct it");
      if (group.velocity[c].empty() && group.displacement[c].empty()) continue;
      if (!group.velocity[c].empty() && !group.displacement[c].empty())
        refuse(group, k, "has a velocity and a displacement", "keep one of them");
      for (const std::uint32_t i : group.bodies) {
        const Body& body = scene.bodies[i];
        if (!body.fixed && !freedom::is_in(body.held, k))
          refuse(group, k, fmt::format("moves particle {}, which is not held there", body.id), "hold it");
        if (freedom::is_in(moved[i], k))
          refuse(group, k, fmt::format("moves particle {}, as another group does", body.id),
                 "keep one of them");
        moved[i] |= freedom::Mask(1u << k);
      }
    }
  }
}

}  // namespace

const Scene& checked(const Scene& scene) {
  if (!(scene.step > 0)) throw Error("the time step is not above 0; give time.step in s");
  const std::size_t materials = scene.materials.size();
  if (scene.law_of.size() != materials * materials)
    throw Error(fmt::format("law_of has {} instead of {} for {}; give a law for each pair of materials",
                            counted(scene.law_of.size(), "entry", "entries"), materials * materials,
                            counted(materials, "material")));
  for (const std::uint32_t law : scene.law_of)
    if (law >= scene.laws.size())
      throw Error(fmt::format("law_of names law {} of {}; give the index of a law", law, scene.laws.size()));
  for (const Body& b : scene.bodies) {
    if (!std::isfinite(norm(b.position)) || !std::isfinite(norm(b.velocity)) || !std::isfinite(norm(b.spin)))
      throw Error(
          fmt::format("particle {}: position, velocity or spin is not a finite number; correct it", b.id));
    if (!(b.radius > 0 && std::isfinite(b.radius) && b.mass > 0 && std::isfinite(b.mass)))
      throw Error(fmt::format("particle {}: radius {:g} m or mass {:g} kg is not above 0; correct it", b.id,
                              b.radius, b.mass));
    if (b.material >= materials)
      throw Error(fmt::format("particle {}: material {} of {}; give the index of a material", b.id,
                              b.material, materials));
  }
  for (const Scene::Boundary& boundary : scene.boundaries)
    if (boundary.material >= materials)
      throw Error(fmt::format("boundary '{}': material {} of {}; give the index of a material", boundary.name,
                              boundary.material, materials));
  check_groups(scene);
  return scene;
}

void report_blow_up(const Simulation& s, double speed_limit) {
  const Particles& p = s.particles();
  const auto name = [&](std::size_t i) { return fmt::format("particle {}", p.id[i]); };
  for (std::size_t i = 0; i < p.size(); ++i) {
    report_not_a_number(s, p.body(i));
    report_speed(s, name(i), norm(p.body(i).velocity), speed_limit);
  }
  report_overlap(s);
  for (std::size_t i = 0; i < p.size(); ++i) {
    Vec3 mid_velocity = {};
    for (int k = 0; k < p.dimension(); ++k) mid_velocity[k] = p.mid_velocity()[k][i];
    report_speed(s, name(i), norm(mid_velocity), speed_limit);
  }
  for (std::size_t k = 0; k < s.surfaces().size(); ++k)
    report_speed(s, "surface " + s.surfaces().names[k], s.surface_speed(k), speed_limit);
  stop("", fmt::format("the motion is no longer finite {}", where(s)),
       fmt::format("use a shorter time.step (now {:g} s)", s.step_length()));
}

namespace {

// Of the centre of a body (m); below 0 behind a wall with one side.
double height_above(const Boundaries& boundaries, const std::vector<PlacedSurface>& surfaces,
                    std::size_t wall, const Particles& p, std::size_t body) {
  Vec3 x = {};
  for (int k = 0; k < p.dimension(); ++k) x[k] = p.position()[k][body];
  const std::size_t planes = boundaries.planes().size();
  if (wall >= planes) return surfaces[wall - planes].nearest(x).distance;
  const scree_plane& plane = boundaries.planes()[wall];
  double height = 0;
  for (int k = 0; k < p.dimension(); ++k) height += (x[k] - plane.point[k]) * plane.normal[k];
  return height;
}

}  // namespace

void check_appeared(const Particles& p, const Boundaries& boundaries,
                    const std::vector<std::uint8_t>& absent_before) {
  const std::vector<PlacedSurface> surfaces = placed_surfaces(boundaries.surfaces(), p.dimension());
  for (std::size_t w = 0; w < absent_before.size(); ++w) {
    if (!absent_before[w] || boundaries.absent()[w]) continue;
    std::size_t behind = 0, deepest = 0;
    double lowest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double height = height_above(boundaries, surfaces, w, p, i);
      if (height < 0) ++behind;
      if (height < lowest) lowest = height, deepest = i;
    }
    if (behind > 0)
      throw Error(
          "",
          fmt::format("wall {} is to be there again with the centre of {} behind it, of body {} by {:.3g} m",
                      boundaries.wall_name(w), counted(behind, "body", "bodies"), p.id[deepest], -lowest),
          "let it come back before they pass, or place it beyond them", ExitStatus::blow_up);
  }
}

}  // namespace scree
