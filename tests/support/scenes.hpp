#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <scree/plugin_host.hpp>
#include <scree/simulation.hpp>

// Small scenes for tests, built without a scenario file.

namespace scree::test {

using Values = std::vector<std::pair<std::string, std::vector<double>>>;

// Plug-ins of the build tree, loaded once for all tests of a program.
inline PluginHost& host() {
  static PluginHost all({SCREE_TEST_PLUGINS});
  return all;
}

// A number for a function of time is a constant.
inline Parameters parameters(const std::string& plugin, scree_kind kind, const Values& values) {
  Parameters p(host().find(plugin, kind));
  for (const auto& [key, value] : values) {
    const scree_parameter* const declared = p.find(key);
    const bool constant = declared && declared->type == SCREE_PROGRAM && value.size() == 1;
    p.set(key, constant ? std::vector<double>{0, value[0]} : value);
  }
  return p;
}

// Sphere (3D) or disc (2D) with the moment of inertia of a homogeneous one.
inline Body body(std::int64_t id, double radius, double mass, const Vec3& position, const Vec3& velocity = {},
                 const Vec3& spin = {}, int dimension = 3) {
  return {.id = id,
          .material = 0,
          .radius = radius,
          .mass = mass,
          .inertia = (dimension == 2 ? 0.5 : 0.4) * mass * radius * radius,
          .position = position,
          .velocity = velocity,
          .spin = spin};
}

// One material and one law for everything.
inline Scene scene(int dimension, double step, std::vector<Body> bodies, const Values& law,
                   const std::string& plugin = "linear_spring_dashpot") {
  Scene s;
  s.dimension = dimension;
  s.step = step;
  s.materials = {"grain"};
  s.bodies = std::move(bodies);
  s.laws = {{plugin, parameters(plugin, SCREE_CONTACT_LAW, law)}};
  s.law_of = {0};
  return s;
}

inline void add_boundary(Scene& s, const std::string& plugin, const Values& values,
                         const std::string& name = "") {
  s.boundaries.push_back({name.empty() ? plugin : name, 0, parameters(plugin, SCREE_BOUNDARY, values)});
}

inline void add_body_force(Scene& s, const std::string& plugin, const Values& values) {
  s.body_forces.push_back({plugin, parameters(plugin, SCREE_BODY_FORCE, values)});
}

inline void run(Simulation& simulation, std::uint64_t steps) {
  for (std::uint64_t k = 0; k < steps; ++k) simulation.step();
}

inline Vec3 position(const Simulation& s, std::size_t i) { return s.particles().body(i).position; }
inline Vec3 velocity(const Simulation& s, std::size_t i) { return s.particles().body(i).velocity; }

inline Vec3 momentum(const Simulation& s) {
  Vec3 sum = {};
  for (std::size_t i = 0; i < s.particles().size(); ++i) sum += s.particles().mass[i] * velocity(s, i);
  return sum;
}

// About the origin; in 2D only z counts.
inline Vec3 angular_momentum(const Simulation& s) {
  Vec3 sum = {};
  for (std::size_t i = 0; i < s.particles().size(); ++i) {
    const Body b = s.particles().body(i);
    sum += b.mass * cross(b.position, b.velocity) + b.inertia * b.spin;
  }
  return sum;
}

}  // namespace scree::test
