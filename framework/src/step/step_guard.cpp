#include "bodies/body_facts.hpp"
#include "contacts/contacts.hpp"
#include "plugins/body_forces.hpp"
#include "walls/boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <scree/closed_forms.hpp>
#include <scree/counted.hpp>
#include <scree/plugin/stability.hpp>
#include <scree/step_guard.hpp>

namespace scree {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double min_speed = 1;  // (m/s)

// Ratio of squared frequencies of the stiffest packing of equal spheres and of a pair: in the face-centred
// cubic lattice with 12 contacts per body, layers that oscillate against each other have ω² = 8 k/m, a pair 2
// k/m.
constexpr double dense_network = 4;

// Mass of the lightest and radius of the smallest body of a material; infinite if it has none.
struct Smallest {
  double mass = infinite, radius = infinite;
  std::size_t count = 0;
};

// Extremes over bodies of a material that can move, and over its fixed ones, whose mass is infinite in a
// contact.
struct OfMaterial {
  Smallest moving, fixed;
};

std::vector<OfMaterial> smallest_bodies(const Scene& scene) {
  std::vector<OfMaterial> all(scene.materials.size());
  for (const Body& body : scene.bodies) {
    OfMaterial& material = all[body.material];
    Smallest& s = body.fixed ? material.fixed : material.moving;
    if (!body.fixed) s.mass = std::min(s.mass, body.mass);
    s.radius = std::min(s.radius, body.radius);
    ++s.count;
  }
  return all;
}

std::optional<double> closed_form(const ConfiguredLaw& law, const scree_encounter& encounter,
                                  std::string_view name) {
  for (const scree_closed_form& form : closed_forms(law, encounter))
    if (form.name == name) return form.value;
  return std::nullopt;
}

scree_encounter encounter_of(const Smallest& a, const Smallest& b, double speed) {
  return {1 / (1 / a.mass + 1 / b.mass), 1 / (1 / a.radius + 1 / b.radius), speed, 1};
}

// Possible contact partners of moving bodies of material `a`: the lightest body of each material, fixed
// bodies and the walls.
std::vector<std::pair<std::size_t, Smallest>> partners(const Scene& scene,
                                                       const std::vector<OfMaterial>& smallest,
                                                       std::size_t a) {
  std::vector<std::pair<std::size_t, Smallest>> all;
  for (std::size_t b = 0; b < smallest.size(); ++b) {
    if (smallest[b].moving.count > (a == b ? 1 : 0)) all.push_back({b, smallest[b].moving});
    if (smallest[b].fixed.count > 0) all.push_back({b, smallest[b].fixed});
  }
  for (const Scene::Boundary& boundary : scene.boundaries) all.push_back({boundary.material, {}});
  return all;
}

// Calls visit(law index, law, encounter) for the lightest pair of every two materials that may touch.
template <class Visit>
void each_encounter(const Scene& scene, double speed, const Visit& visit) {
  const std::vector<OfMaterial> smallest = smallest_bodies(scene);
  const std::size_t materials = smallest.size();
  for (std::size_t k = 0; k < scene.laws.size(); ++k) {
    const ConfiguredLaw law(scene.laws[k].parameters, scene.dimension, no_bounds, no_bounds);
    for (std::size_t a = 0; a < materials; ++a)
      for (const auto& [b, partner] : partners(scene, smallest, a))
        if (smallest[a].moving.count > 0 && scene.law_of[a * materials + b] == k)
          visit(k, law, encounter_of(smallest[a].moving, partner, speed));
  }
}

// Longest stable step (s). A law that states no critical step is treated as linear, with contact time π/ω.
double stable_step(const ConfiguredLaw& law, scree_encounter encounter, double network) {
  encounter.network = network;
  if (const auto critical = closed_form(law, encounter, "critical_step")) return *critical;
  constexpr double pi = std::numbers::pi;
  return 2 / pi / std::sqrt(network) * closed_form(law, encounter, "contact_time").value_or(infinite);
}

// Number of candidate pairs of each wall.
std::vector<std::size_t> bodies_near_walls(const Simulation& s) {
  std::vector<std::size_t> near(s.boundaries().wall_count(), 0);
  for (const PairGroup& group : s.contacts().groups())
    if (group.planes) group.each_pair([&](std::size_t p) { ++near[s.contacts().b[p]]; });
  return near;
}

// The mass of a wall is divided by the number of bodies near it, or of bodies in one face of the packing,
// which it may touch later.
void add_wall(const Simulation& s, std::size_t wall, std::size_t near, double speed,
              std::vector<StepLimit>& limits) {
  const Scene& scene = s.scene();
  const double mass = s.boundaries().wall_mass(wall);
  const double face = std::pow(double(s.scene().bodies.size()), 1 - 1.0 / s.dimension());
  const double count = std::max(double(near), std::floor(face));
  const std::vector<OfMaterial> smallest = smallest_bodies(scene);
  for (std::size_t a = 0; a < smallest.size(); ++a) {
    const std::size_t k = scene.law_of[a * smallest.size() + s.boundaries().wall_materials()[wall]];
    const ConfiguredLaw law(scene.laws[k].parameters, s.dimension(), no_bounds, no_bounds);
    for (const Smallest& body : {smallest[a].moving, smallest[a].fixed})
      if (body.count > 0)
        limits.push_back(
            {fmt::format("wall '{}' of {:g} kg against the {} near it", s.boundaries().wall_name(wall), mass,
                         counted(std::size_t(count), "body", "bodies")),
             stable_step(law, encounter_of(body, {mass / count, infinite}, speed), 1)});
  }
}

void add_walls(const Simulation& s, double speed, std::vector<StepLimit>& limits) {
  const std::vector<std::size_t> near = bodies_near_walls(s);
  for (std::size_t w = 0; w < near.size(); ++w)
    if (s.boundaries().wall_mass(w) > 0) add_wall(s, w, near[w], speed, limits);
}

void add_viscosity(const Simulation& s, std::vector<StepLimit>& limits) {
  if (const double rate = s.boundaries().largest_damping_rate(); rate > 0)
    limits.push_back(
        {fmt::format("the viscosity of a wall, which damps it at {:.3g}/s,", rate), critical_step(0, rate)});
}

void add_body_forces(const Simulation& s, std::vector<StepLimit>& limits) {
  const double rate = s.body_forces().largest_damping_rate(s.scene().bodies);
  if (rate > 0)
    limits.push_back({fmt::format("the drag of a body force, which damps a body at {:.3g}/s,", rate),
                      critical_step(0, rate)});
}

void add_motion(const Simulation& s, std::vector<StepLimit>& limits) {
  double fastest = s.boundaries().displacement_speed();
  const Vec3 drift = drift_velocity(s.scene());
  for (std::size_t i = 0; i < s.particles().size(); ++i)
    fastest = std::max(fastest, norm(s.particles().body(i).velocity - drift));
  for (const scree_plane& plane : s.planes())
    fastest = std::max(fastest, norm(Vec3{{plane.velocity[0], plane.velocity[1], plane.velocity[2]}}));
  for (std::size_t k = 0; k < s.surfaces().size(); ++k) fastest = std::max(fastest, s.surface_speed(k));
  if (fastest > 0 && !s.scene().bodies.empty())
    limits.push_back(
        {fmt::format("the skin of {:.3g} m, which the fastest body or wall crosses at {:.3g} m/s,",
                     s.first_skin(), fastest),
         s.first_skin() / fastest});
}

}  // namespace

Vec3 drift_velocity(const Scene& scene) {
  return boundaries_of(scene).wall_count() == 0 ? drift_of(scene.bodies) : Vec3{};
}

double expected_speed(const Scene& scene) {
  if (scene.expected_speed > 0) return scene.expected_speed;
  double fastest = 0;
  const Vec3 drift = drift_velocity(scene);
  for (const Body& body : scene.bodies) fastest = std::max(fastest, norm(body.velocity - drift));
  return std::max(min_speed, 2 * fastest);
}

double shortest_contact_time(const Scene& scene, double speed) {
  double shortest = infinite;
  each_encounter(scene, speed, [&](std::size_t, const ConfiguredLaw& law, const scree_encounter& encounter) {
    shortest = std::min(shortest, closed_form(law, encounter, "contact_time").value_or(infinite));
  });
  return shortest;
}

std::vector<StepLimit> step_limits(const Simulation& s) {
  const Scene& scene = s.scene();
  const double speed = expected_speed(scene);
  const double network = scene.bodies.size() + s.planes().size() > 2 ? dense_network : 1;
  std::vector<StepLimit> limits;
  each_encounter(
      scene, speed, [&](std::size_t k, const ConfiguredLaw& law, const scree_encounter& encounter) {
        limits.push_back({fmt::format("the contacts of law '{}'", scene.laws[k].name),
                          stable_step(law, encounter, network)});
        if (const auto wave = closed_form(law, encounter, "rayleigh_time"))
          limits.push_back({fmt::format("the Rayleigh wave of {:.3g} s across the smallest body of law '{}'",
                                        *wave, scene.laws[k].name),
                            0.5 * *wave});
      });
  add_walls(s, speed, limits);
  add_viscosity(s, limits);
  add_body_forces(s, limits);
  for (StepLimit& limit : limits) limit.longest_step *= traits_of(scene.integration).stable_step;
  add_motion(s, limits);
  return limits;
}

StepLimit shortest_limit(const Simulation& simulation) {
  StepLimit shortest = {"", infinite};
  for (const StepLimit& limit : step_limits(simulation))
    if (limit.longest_step < shortest.longest_step) shortest = limit;
  return shortest;
}

}  // namespace scree
