#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <scree/quasi_static/follow.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::quasi_static {

// The entries of quasi_static.json between its status and its warnings.
nlohmann::ordered_json record_of(const FollowedLoad& load);

// What charts of a load show: the deviatoric strain, or the displacement (m) and force (N) of a surface.
struct ChartedLoad {
  const FollowedLoad& load;
  const std::vector<double>&times, &values, &forces;
  std::string surface;  // its name; "": the strain
};
// Over time, and for a surface the force over the displacement.
void draw_charts(const ChartedLoad& charted, const run::RunDirectory& directory);

}  // namespace scree::quasi_static
