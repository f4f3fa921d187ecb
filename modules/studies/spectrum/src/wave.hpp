#pragma once

#include <vector>

#include <scree/scene.hpp>
#include <scree/simulation.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::spectrum {

// A displacement of the driven wall as a function of time, in the form of program.hpp.
using Wave = std::vector<double>;

// The parameters of a scene with the wave for its driven wall.
void set_wave(Scene& scene, const SpectrumPlan& plan, const Wave& wave);

// The same for a simulation between two steps; the wave begins now.
void start_wave(Simulation& simulation, const SpectrumPlan& plan, const Wave& wave);

}  // namespace scree::spectrum
