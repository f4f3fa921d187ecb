#pragma once

#include "meshes.hpp"
#include "packings.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace scree::test {

// Bodies of radius 1 far from each other, each on a surface of its own, in which it is by 0.05 to 0.07:
// faces, edges and corners, from inside and outside, with frames that are turned. Meshes come last.
inline Scene surface_beds(int dimension, const Values& law, const std::string& plugin) {
  struct Bed {
    std::string plugin;
    Values values;
    Vec3 centre;  // of the body, from the place of the bed
  };
  const double diagonal = std::sqrt(0.5);
  std::vector<Bed> beds = {
      {"cylinder", {{"radius", {3}}}, {{2.07 * std::cos(0.4), 2.07 * std::sin(0.4), 0}}},
      {"sphere", {{"radius", {1.5}}}, {{2.45 * std::cos(2), 2.45 * std::sin(2), 0}}},
      {"rectangle",
       {{"normal", {1, 1, 0}}, {"length", {4}}},
       {{0.93 * diagonal - 0.3 * diagonal, 0.93 * diagonal + 0.3 * diagonal, 0}}},
      {"rectangle", {{"normal", {0, 1, 0}}, {"length", {2}}}, {{1.6, 0.7236, 0}}},
      {"sphere", {{"radius", {2}}, {"high", {0.5}}, {"axis", {0, 1, 0}}}, {{1.6365, 1.39, 0}}}};
  if (dimension == 3) {
    const double across = 1.8424 * diagonal;
    beds = {
        {"cylinder",
         {{"radius", {3}}, {"axis", {0, 1, 0}}},
         {{2.07 * std::cos(0.4), 0.3, 2.07 * std::sin(0.4)}}},
        {"cylinder", {{"radius", {2}}, {"axis", {0, 1, 0}}}, {{2.94 * std::cos(2), 0.1, 2.94 * std::sin(2)}}},
        {"cone",
         {{"radius", {1}}, {"end_radius", {4}}, {"length", {3}}, {"axis", {1, 0, 0}}},
         {{2.1576, across, across}}},
        {"sphere", {{"radius", {4}}}, {{3.07 * 2 / 3, 3.07 / 3, -3.07 * 2 / 3}}},
        {"sphere", {{"radius", {1.5}}}, {{2.45 / 3, 2.45 * 2 / 3, -2.45 * 2 / 3}}},
        {"rectangle",
         {{"normal", {0, 1, 1}}, {"along", {1, 0, 0}}, {"length", {4}}, {"width", {2}}},
         {{2.6, 0.7236 * diagonal, 0.7236 * diagonal}}},
        {"rectangle",
         {{"normal", {0, 1, 0}}, {"along", {1, 0, 0}}, {"length", {2}}, {"width", {2}}},
         {{1.5, 0.7018, 1.4}}},
        {"disc", {{"normal", {1, 1, 0}}, {"radius", {1.5}}}, {{0.8 * diagonal, 0.8 * diagonal, 2}}},
        {"disc", {{"normal", {1, 0, 0}}, {"radius", {3}}, {"hole", {0.5}}}, {{0.85, 0, 0.1}}},
        {"sphere", {{"radius", {2}}, {"high", {0.5}}, {"axis", {0, 1, 0}}}, {{1.6365, 1.39, 0}}}};
    const Values box = {{"file", box_mesh({{1.5, 1.5, 1.5}}).numbers()}};

    for (const Vec3& centre : {Vec3{{0.3, 2.43, 0.2}}, Vec3{{2.1, 2.22, 0.3}}, Vec3{{2, 2.05, 2.08}}})
      beds.push_back({"mesh", box, centre});
  }
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < beds.size(); ++i)
    bodies.push_back(
        body(std::int64_t(i), 1, heavy, Vec3{{20 * double(i), 0, 0}} + beds[i].centre, {}, {}, dimension));
  Scene s = scene(dimension, 1e-3, std::move(bodies), law, plugin);
  for (std::size_t i = 0; i < beds.size(); ++i) {
    beds[i].values.push_back({beds[i].plugin == "mesh" ? "translation" : "point", {20 * double(i), 0, 0}});
    add_boundary(s, beds[i].plugin, beds[i].values, "bed" + std::to_string(i));
  }
  return s;
}

// A body in a trough along y (m), whose period ends at 0.304.
inline Scene periodic_trough(const Values& law, const std::string& plugin, double y) {
  const Vec3 centre = {{2.07 * std::cos(0.4), y, 2.07 * std::sin(0.4)}};
  Scene s = scene(3, 1e-3, {body(0, 1, heavy, centre)}, law, plugin);
  add_boundary(s, "periodic", {{"axes", {1}}, {"lower", {0, -5, 0}}, {"upper", {0, 0.304, 0}}});
  add_boundary(s, "cylinder", {{"point", {0, 0, 0}}, {"axis", {0, 1, 0}}, {"radius", {3}}}, "trough");
  return s;
}

// A disc with three fixed beads, on which its springs exert 30 N.
inline Scene disc_on_beads(double force, double torque) {
  std::vector<Body> beads;
  for (const double angle : {0.1, 2.2, 4.3})
    beads.push_back(
        body(std::int64_t(beads.size()), 0.3, 1, {{0.7 * std::cos(angle), 0.7 * std::sin(angle), -0.29}}));
  Scene scene = test::scene(3, 1e-4, beads,
                            {{"normal_stiffness", {1000}},
                             {"normal_damping", {0}},
                             {"tangential_stiffness", {600}},
                             {"static_friction", {1}}});
  for (Body& bead : scene.bodies) bead.fixed = true;
  add_boundary(scene, "disc",
               {{"point", {0, 0, 0}},
                {"normal", {0, 0, -1}},
                {"radius", {1}},
                {"force", {force}},
                {"mass", {1}},
                {"torque", {torque}},
                {"inertia", {1}}});
  return scene;
}

}  // namespace scree::test
