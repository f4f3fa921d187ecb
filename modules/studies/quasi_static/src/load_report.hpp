#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <scree/quasi_static/follow.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::quasi_static {

// The entries of quasi_static.json between its status and its warnings.
nlohmann::ordered_json record_of(const FollowedLoad& load);

// What a chart of a load shows: the deviatoric strain, or the displacement (m) of a surface.
struct ChartedLoad {
  const FollowedLoad& load;
  const std::vector<double>&times, &values;
  bool of_surface;
};
// With pictures: over time.
void draw_chart(const ChartedLoad& charted, const run::RunDirectory& directory);

}  // namespace scree::quasi_static
