#include "step/simulation_parts.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/simulation.hpp>

// New parameters between two steps.
namespace scree {

namespace {

template <class Entries>
Parameters& parameters_in(Entries& entries, const char* kind, const std::string& name) {
  for (auto& entry : entries)
    if (entry.name == name) return entry.parameters;
  throw Error(fmt::format("no {} '{}'", kind, name));
}

}  // namespace

void Simulation::reconfigure_law(const std::string& name, const Parameters& parameters) {
  Parameters& present = parameters_in(parts_->scene.laws, "contact law", name);
  parts_->command_change(RankCommand::change_law, name, parameters, {});
  parts_->stepper.synchronise();
  present = parameters;
}

void Simulation::reconfigure_boundary(const std::string& name, const Parameters& parameters,
                                      const std::vector<std::string>& going_on) {
  Parameters& present = parameters_in(parts_->scene.boundaries, "boundary", name);
  parts_->command_change(RankCommand::change_boundary, name, parameters, going_on);
  parts_->stepper.synchronise();
  parts_->audit.add_turned_over(parts_->boundaries.energy().kinetic);
  parts_->boundaries.reconfigure(name, parameters, time(), going_on);
  present = parameters;
}

void Simulation::check_returning_walls(const std::string& name, const Parameters& parameters,
                                       const std::vector<std::string>& going_on) {
  const std::vector<std::uint8_t>& absent = absent_walls();
  if (std::find(absent.begin(), absent.end(), 1) == absent.end()) return;
  parts_->check_returning_walls(name, parameters, going_on);
}

void Simulation::reconfigure_body_force(const std::string& name, const Parameters& parameters,
                                        const std::vector<std::string>& going_on) {
  Parameters& present = parameters_in(parts_->scene.body_forces, "body force", name);
  parts_->command_change(RankCommand::change_body_force, name, parameters, going_on);
  parts_->stepper.synchronise();
  parts_->body_forces.reconfigure(name, parameters, time(), going_on);
  present = parameters;
}

void Simulation::apply_reconfiguration() {
  SimulationParts& p = *parts_;
  p.check_appeared_walls();
  p.command(RankCommand::apply_changes);
  p.configure_laws();
  for (PairGroup& group : p.contacts.groups())
    group.history_width = p.laws[group.law].interface.history_width;
  p.search_neighbours();
  p.stepper.reevaluate_forces(0);
  p.integrator->restart();
  p.audit.set_stored(p.contact_sums, p.body_sums);
  p.audit.add_lost(p.contact_sums);
}

}  // namespace scree
