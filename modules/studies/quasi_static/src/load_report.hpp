#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <scree/quasi_static/follow.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::quasi_static {

// The entries of quasi_static.json between its status and its warnings.
nlohmann::ordered_json record_of(const FollowedLoad& load);

// With pictures: deviatoric strain over time.
void draw_chart(const FollowedLoad& load, const std::vector<double>& times,
                const std::vector<double>& strains, const run::RunDirectory& directory);

}  // namespace scree::quasi_static
