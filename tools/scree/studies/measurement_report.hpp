#pragma once

#include <functional>

#include <scree/error.hpp>
#include <scree/spectrum/measurement.hpp>

namespace scree::tool {

// Calls work with options that show progress and warnings and let Ctrl-C stop it, then prints the result.
// Returns the exit status.
ExitStatus report_measurement(bool quiet,
                              const std::function<spectrum::Measurement(spectrum::MeasurementOptions)>& work);

}  // namespace scree::tool
