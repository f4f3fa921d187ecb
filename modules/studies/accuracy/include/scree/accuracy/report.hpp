#pragma once

#include <string>

#include <scree/accuracy/study.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::accuracy {

// One sentence: the cheapest setting within the tolerance, or, if there is none, the most accurate setting.
std::string verdict(const Study& study);
// Report for a terminal: table of settings, orders, references, horizon and verdict.
std::string text_report(const Study& study);
// One row per setting: integrator, precision, step_s, steps, wall_s, worst_error, then value and error of
// each quantity; problem.
std::string csv_report(const Study& study);

// Writes accuracy.csv, accuracy.json and charts/<quantity>.png (error against wall time with the Pareto
// front), of the worst error and of up to six quantities, to the directory of a study; no charts if the
// program was built without pictures. Throws Error (failure) if a file cannot be written.
void write_report(const Study& study, const std::string& title, run::RunDirectory& directory);

}  // namespace scree::accuracy
