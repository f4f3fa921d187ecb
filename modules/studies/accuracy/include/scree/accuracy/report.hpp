#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include <scree/accuracy/study.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::accuracy {

// One sentence: the cheapest setting within the tolerance, or, if there is none, the most accurate setting.
std::string verdict(const Convergence& study);
// Report for a terminal: table of settings, orders, references, horizon and verdict.
std::string text_report(const Convergence& study);
// One row per setting: integrator, step_s, steps, wall_s, worst_error, then value and error of
// each quantity; problem.
std::string csv_report(const Convergence& study);

// The entries of accuracy.json between its status and its warnings.
nlohmann::ordered_json record_of(const Convergence& study);
// Of accuracy.json: the options of scree accuracy, by their names.
nlohmann::ordered_json json_of(const StudyOptions& options);
// accuracy.csv: csv_report(). Throws Error (failure) if it cannot be written.
void write_table(const Convergence& study, const run::RunDirectory& directory);
// charts/<quantity>.png: error against wall time with the Pareto front, of the worst error and of up to six
// quantities; none if the program was built without pictures.
void draw_charts(const Convergence& study, const std::string& title, const run::RunDirectory& directory);

}  // namespace scree::accuracy
