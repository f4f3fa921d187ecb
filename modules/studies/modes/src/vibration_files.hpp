#pragma once

#include <nlohmann/json_fwd.hpp>

#include <scree/modes/vibration.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::modes {

// The entries of modes.json between its status and its warnings.
nlohmann::ordered_json record_of(const Vibration& vibration);

// Of modes.json: the options of scree modes that change what it finds, by their names.
nlohmann::ordered_json json_of(const VibrationOptions& options);

// modes.csv, floppy.csv, elastic.csv and density.csv, those that there are.
void write_tables(const Vibration& vibration, const run::RunDirectory& directory);

// Charts of the density of states.
void draw_charts(const Vibration& vibration, const run::RunDirectory& directory);

// "Pa", in 2D "N/m".
const char* unit_of_moduli(const response::ElasticModuli& moduli);

}  // namespace scree::modes
