#pragma once

#include <string>

#include <scree/accuracy/study.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::accuracy {

// One sentence: the cheapest setting that meets the tolerance, or that none does and which comes nearest.
std::string verdict(const Study& study);
// The table, the orders, the horizon and the verdict, for a terminal.
std::string text_report(const Study& study);
// One row per setting: integrator, precision, step_s, steps, wall_s, worst_error, then value and error of
// each quantity; problem.
std::string csv_report(const Study& study);

// Writes accuracy.csv, accuracy.json and charts/<quantity>.png (error against wall time with the Pareto
// front), of the worst error and of up to six quantities, into the directory of a study; no charts where the
// program was built without pictures. Throws Error (failure) where it cannot.
void write_report(const Study& study, const std::string& title, const run::RunDirectory& directory);

}  // namespace scree::accuracy
