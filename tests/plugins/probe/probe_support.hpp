#pragma once

#include "scenes.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/probes.hpp>

namespace scree::test {

inline const Values elastic_law = {{"normal_stiffness", {5000}}, {"normal_damping", {0}}};
inline const Values frictional_law = {{"normal_stiffness", {5000}},
                                      {"normal_damping", {0.5}},
                                      {"tangential_stiffness", {1000}},
                                      {"static_friction", {0.3}}};

// One row of a probe, by column name.
struct Sampled {
  std::vector<std::string> names;
  std::vector<double> row;
  double operator[](const std::string& name) const {
    const auto at = std::find(names.begin(), names.end(), name);
    REQUIRE(at != names.end());
    return row[std::size_t(at - names.begin())];
  }
};

inline Sampled sample(const Simulation& s, const std::string& plugin, const Values& values = {},
                      std::vector<std::uint8_t> left_out = {}) {
  Probe probe(parameters(plugin, SCREE_PROBE, values), s.dimension(), std::move(left_out));
  return {probe.names(), probe.sample(SimulationView(s, probe.needs()).get())};
}

}  // namespace scree::test
