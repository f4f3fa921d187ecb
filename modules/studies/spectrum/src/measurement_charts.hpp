#pragma once

#include <functional>
#include <string>

#include <scree/run/run_directory.hpp>
#include <scree/spectrum/measurement.hpp>

namespace scree::spectrum {

// Charts of a measurement: of each column the curves of all methods with their named peaks,
// and the shapes of the peaks. Charts that cannot be drawn are reported, in one line each.
void draw_charts(const Measurement& measurement, const run::RunDirectory& directory,
                 const std::function<void(const std::string&)>& report);

}  // namespace scree::spectrum
