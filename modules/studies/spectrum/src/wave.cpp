#include "wave.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::spectrum {

namespace {

Parameters with_wave(const Scene& scene, const SpectrumPlan& plan, const Wave& wave) {
  Parameters parameters = std::find_if(scene.boundaries.begin(), scene.boundaries.end(), [&](const auto& b) {
                            return b.name == plan.boundary;
                          })->parameters;
  parameters.set(plan.key, wave);
  return parameters;
}

}  // namespace

void set_wave(Scene& scene, const SpectrumPlan& plan, const Wave& wave) {
  for (Scene::Boundary& boundary : scene.boundaries)
    if (boundary.name == plan.boundary) boundary.parameters = with_wave(scene, plan, wave);
}

void start_wave(Simulation& simulation, const SpectrumPlan& plan, const Wave& wave) {
  try {
    simulation.reconfigure_boundary(plan.boundary, with_wave(simulation.scene(), plan, wave));
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", plan.drive_place, error.what()));
  }
  simulation.apply_reconfiguration();
}

}  // namespace scree::spectrum
