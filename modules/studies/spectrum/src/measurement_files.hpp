#pragma once

#include "sweep_points.hpp"

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <scree/run/run_directory.hpp>
#include <scree/spectrum/measurement.hpp>

namespace scree::spectrum {

// The entries of spectrum.json between its status and its warnings.
nlohmann::ordered_json record_of(const Measurement& measurement);

// sweep.csv: one row per frequency, in the order of the sweep.
std::string sweep_table(const std::vector<ObservedColumn>& observed, const std::vector<SweepPoint>& points);

// spectrum.csv, peaks.csv, methods.csv and, if there are any, shapes.csv.
void write_tables(const Measurement& measurement, const run::RunDirectory& directory);

// Charts of a measurement: of each column the curves of all methods with their named peaks,
// and the shapes of the peaks. Charts that cannot be drawn are reported, in one line each.
void draw_charts(const Measurement& measurement, const run::RunDirectory& directory,
                 const std::function<void(const std::string&)>& report);

// Whether a peak has a name that no larger one of the same method and column has.
bool is_largest_of_name(const Measurement& measurement, const Peak& peak);

// Unit of a column per drive: "1/m" of a strain.
std::string unit_of_response(const ObservedColumn& column);

}  // namespace scree::spectrum
