#pragma once

#include <string>

#include <scree/modes/vibration.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::modes {

inline constexpr const char* record_name = "response.json";

// The record, by which the directory is known.
void write_record(const std::string& status, const Vibration& vibration, const run::RunDirectory& directory);

// modes.csv, floppy.csv, elastic.csv and density.csv, those that there are.
void write_tables(const Vibration& vibration, const run::RunDirectory& directory);

// With pictures: charts of the density of states.
void draw_charts(const Vibration& vibration, const run::RunDirectory& directory);

// "Pa", in 2D "N/m".
const char* unit_of_moduli(const response::ElasticModuli& moduli);

}  // namespace scree::modes
