#pragma once

#include "law_batch.hpp"

#include <cmath>

// Parameters that select every kernel of every law, for tests of all of them.

namespace scree::test {

struct Variant {
  std::string law;
  std::string name;
  Values values;
  double stiffness;  // of the normal force at the overlap of the states (N/m), for the scale of forces
  double slip;       // spring length at which the contact begins to slide (m)
  bool frictional;
};

inline void add_linear_variants(std::vector<Variant>& all) {
  for (const double rolling : {0.0, 0.1})
    for (const bool by_restitution : {false, true})
      for (const double tension : {0.0, 1.0})
        for (const auto& [friction, dynamic] :
             {std::pair{0, 0.0}, {1, 0.5}, {1, 0.4}, {2, 0.5}, {2, 0.4}, {3, 0.4}}) {
          Values v = {{"normal_stiffness", {5000}}, {"rolling_friction", {rolling}}, {"tension", {tension}}};
          v.push_back(by_restitution ? std::pair<std::string, std::vector<double>>{"restitution", {0.8}}
                                     : std::pair<std::string, std::vector<double>>{"normal_damping", {0.4}});
          if (friction > 0) {
            v.push_back({"tangential_stiffness", {1500}});
            v.push_back({"static_friction", {0.5}});
            v.push_back({"dynamic_friction", {dynamic}});
            v.push_back({"tangential_damping", {friction == 1 ? 0.0 : 0.2}});
            v.push_back({"slip_rule", {friction == 3 ? 1.0 : 0.0}});
          }
          all.push_back({"linear_spring_dashpot",
                         "friction " + std::to_string(friction) + ", dynamic " + std::to_string(dynamic) +
                             ", rolling " + std::to_string(rolling) + ", restitution " +
                             std::to_string(by_restitution) + ", tension " + std::to_string(tension),
                         v, 5000, 0.5 * 5000 * 2e-5 / 1500, friction > 0});
        }
}

inline void add_hertz_variants(std::vector<Variant>& all) {
  for (const double rolling : {0.0, 0.1})
    for (const double restitution : {0.8, 1.0})
      for (const double friction : {0.0, 0.4})
        for (const double history : {0.0, 1.0, 2.0})
          all.push_back({"hertz_mindlin",
                         "friction " + std::to_string(friction) + ", rolling " + std::to_string(rolling) +
                             ", restitution " + std::to_string(restitution) + ", history " +
                             std::to_string(history),
                         {{"youngs_modulus", {7e7}},
                          {"poissons_ratio", {0.2}},
                          {"restitution", {restitution}},
                          {"friction", {friction}},
                          {"history", {history}},
                          {"rolling_friction", {rolling}}},
                         1e4,
                         0.4 * 2e-5 * 2.0 / 3.0 * 0.9,
                         friction > 0});
}

inline void add_disc_variants(std::vector<Variant>& all) {
  for (const std::string law : {"disc_angular", "disc_corrected", "disc_cundall_strack"})
    for (const bool area : {false, true})
      for (const double friction : {0.0, 0.5})
        // k A/(4 R*) of the states is 0.1 N too.
        all.push_back({law,
                       "friction " + std::to_string(friction) + ", area " + std::to_string(area),
                       {{"normal", {area ? 1.0 : 0.0}},
                        {"normal_stiffness", {area ? 7.5e4 : 5000.0}},
                        {"normal_damping", {0.4}},
                        {"tangential_stiffness", {1500}},
                        {"tangential_damping", {0.2}},
                        {"friction", {friction}}},
                       5000,
                       0.5 * 0.1 / 1500,
                       friction > 0});
}

inline void add_sphere_variants(std::vector<Variant>& all) {
  for (const double friction : {0.0, 0.4}) {
    const std::string name = "friction " + std::to_string(friction);
    for (const bool by_restitution : {false, true})
      for (const double share : {1.0, 0.8})
        all.push_back({"sphere_path_independent",
                       "linear, " + name + ", dynamic " + std::to_string(share * friction) +
                           ", restitution " + std::to_string(by_restitution),
                       {{"normal_stiffness", {5000}},
                        {by_restitution ? "restitution" : "normal_damping", {0.8}},
                        {"tangential_stiffness", {1500}},
                        {"tangential_damping", {0.2}},
                        {"static_friction", {friction}},
                        {"dynamic_friction", {share * friction}}},
                       5000,
                       0.4 * 0.1 / 1500,
                       friction > 0});
    all.push_back({"sphere_path_independent",
                   "hertz, " + name,
                   {{"normal", {1}},
                    {"youngs_modulus", {7e7}},
                    {"poissons_ratio", {0.2}},
                    {"restitution", {0.8}},
                    {"friction", {friction}}},
                   1e4,
                   0.4 * 2e-5 * 2.0 / 3.0 * 0.9,
                   friction > 0});
  }
}

inline std::vector<Variant> variants() {
  std::vector<Variant> all;
  add_linear_variants(all);
  add_hertz_variants(all);
  add_disc_variants(all);
  add_sphere_variants(all);
  return all;
}

}  // namespace scree::test
