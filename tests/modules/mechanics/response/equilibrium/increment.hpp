#pragma once

#include "equilibrium/static_contacts.hpp"
#include "packings.hpp"
#include "surface_beds.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace scree::test {

using namespace response;

inline constexpr double share = 0.02;  // of a radius, by which bodies move in a step

inline Scene with_motions(Scene s) {
  for (std::size_t i = 0; i < s.bodies.size(); ++i)
    for (int k = 0; k < (s.dimension == 2 ? 3 : 6); ++k)
      motion(s.bodies[i], s.dimension, k) = share * std::sin(1.0 + 2.3 * double(i) + 1.7 * k) / s.step;
  return s;
}

// Bodies on surfaces that move by themselves.
inline Scene moving_beds(int dimension, const std::string& plugin, const Values& law) {
  return with_motions(surface_beds(dimension, law, plugin));
}

// A heap whose bodies move by themselves, and one that first touches it in the middle of the step.
inline Scene moving_heap(int dimension, const std::string& plugin, const Values& law) {
  Scene s = heap(dimension, law, plugin);
  const Vec3 last = s.bodies.back().position;
  const double gap = 0.5 * share;
  s.bodies.push_back(
      body(9, 1, heavy, last + Vec3{{s.bodies.back().radius + 1 + gap, 0, 0}}, {}, {}, dimension));
  s = with_motions(std::move(s));
  s.bodies.back().velocity = s.bodies[s.bodies.size() - 2].velocity - Vec3{{2 * gap / s.step, 0, 0}};
  return s;
}

// The bodies of a scene and the motion of a step, as a quasi-static increment.
struct Increment {
  Simulation simulation;
  DegreesOfFreedom freedom;
  StaticContacts contacts;
  Eigen::VectorXd motion;
  StaticConfiguration after;
  StaticLoads loads;

  explicit Increment(const Scene& scene)
      : simulation(scene),
        freedom(scene.dimension, spins(), everybody(), everybody(),
                std::vector<bool>(simulation.linear_walls().walls.size())),
        contacts(simulation, spins()),
        motion(freedom.size()),
        after(simulation) {
    contacts.find_pairs(after, 0.2);
    for (std::size_t i = 0; i < freedom.bodies(); ++i) {
      for (int k = 0; k < scene.dimension; ++k)
        motion[freedom.translation(i, k)] = scene.step * scene.bodies[i].velocity[k];
      for (int k = 0; k < spins(); ++k)
        motion[freedom.rotation(i, k)] = scene.step * scene.bodies[i].spin[scene.dimension == 2 ? 2 : k];
    }
  }

  int spins() const {
    return simulation.particles().spin_axes().last - simulation.particles().spin_axes().first;
  }
  std::vector<bool> everybody() const { return std::vector<bool>(simulation.particles().size(), true); }

  void evaluate(const Eigen::VectorXd& moved) {
    const StaticMotion all(moved, freedom, simulation.linear_walls());
    after = StaticConfiguration(simulation);
    after.move(all);
    const std::size_t ends = after.position.size();
    loads = {std::vector<Vec3>(ends), std::vector<Vec3>(ends)};
    contacts.evaluate(after, all, loads);
  }
};

}  // namespace scree::test
