#pragma once

#include "sweep_point.hpp"

#include <vector>

#include <scree/scenario/spectrum_plan.hpp>

namespace scree::spectrum {

// The frequencies with which a sweep begins, in its order: all, or those of a coarse grid if it is adaptive.
std::vector<double> first_frequencies(const scenario::SpectrumPlan& plan);

// Frequencies of the grid between points among which the response varies: its phase by more than 0.4, its logarithm by more than
// 0.3, or at a maximum; in the order of the sweep. Empty if the response follows from the points. Two resonances, or one and an
// antiresonance, that lie together between neighbours of the coarse grid can be overlooked.
std::vector<double> further_frequencies(const scenario::SpectrumPlan& plan, std::vector<SweepPoint> points);

}  // namespace scree::spectrum
