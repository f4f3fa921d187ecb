#pragma once

#include <vector>

#include <scree/scenario/spectrum_plan.hpp>
#include <scree/spectrum/road_spectrum.hpp>

namespace scree::spectrum {

// Frequencies about maxima that are too narrow for the frequencies of a road to give their widths: with them, a width has eight. Of the
// columns that respond; empty where all maxima are wide enough. Increasing, without those of the road.
std::vector<double> frequencies_about_maxima(const scenario::SpectrumPlan& plan, const RoadSpectrum& road);

// The first of these frequencies, as many as can be solved at once for so many bodies within 2 GB of motions.
std::vector<double> first_batch(std::vector<double> frequencies, std::size_t bodies);

}  // namespace scree::spectrum
