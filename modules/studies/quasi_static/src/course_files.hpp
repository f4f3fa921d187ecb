#pragma once

#include <string>
#include <vector>

#include <scree/quasi_static/follow.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::quasi_static {

// response.json, by which the directory is known.
void write_record(const std::string& status, const Course& course, const run::RunDirectory& directory);

// With pictures: deviatoric strain over time.
void draw_chart(const Course& course, const std::vector<double>& times, const std::vector<double>& strains,
                const run::RunDirectory& directory);

}  // namespace scree::quasi_static
