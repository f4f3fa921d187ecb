#pragma once

#include <cstddef>
#include <vector>

#include <scree/spectrum/method_spectrum.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

// The frequencies at which the linear response is solved, and in which order.
namespace scree::spectrum {

// Frequencies about maxima that are too narrow for the grid to give their widths: with them, a width has
// eight. Of the columns that respond; empty where all maxima are wide enough. Increasing, without the
// frequencies of the spectrum.
std::vector<double> frequencies_about_maxima(const SpectrumPlan& plan, const MethodSpectrum& spectrum);

// Those of all frequencies that are not among the found ones. Both increase.
std::vector<double> missing(const std::vector<double>& all, const std::vector<double>& found);

// The first of these frequencies, as many as can be solved at once for so many bodies within 2 GB of motions.
std::vector<double> first_batch(std::vector<double> frequencies, std::size_t bodies);

}  // namespace scree::spectrum
