#include "readers.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/pictures/load_backend.hpp>
#include <scree/probes.hpp>
#include <scree/scenario/quantities.hpp>
#include <scree/scene_checks.hpp>

// What the parts of a plan need of its scene.

namespace scree::scenario {

namespace {

bool needs(const ProbePlan& probe, const Plan& plan, std::uint32_t what) {
  return Probe(probe.parameters, plan.scene.dimension).needs() & what;
}

bool any_probe_needs(const Plan& plan, std::uint32_t what) {
  return std::any_of(plan.probes.begin(), plan.probes.end(),
                     [&](const ProbePlan& probe) { return needs(probe, plan, what); });
}

// Whether a law, in the scene or in a stage, needs a quantity, which then exists from the start.
bool any_law(const Plan& plan, bool (*needs)(const Parameters& law, int dimension)) {
  for (const Scene::Law& law : plan.scene.laws)
    if (needs(law.parameters, plan.scene.dimension)) return true;
  for (const Stage& stage : plan.stages)
    for (const Stage::Change& change : stage.changes)
      if (change.kind == SCREE_CONTACT_LAW && needs(change.parameters, plan.scene.dimension)) return true;
  return false;
}

}  // namespace

bool needs_spin(const Plan& plan) { return any_law(plan, &exerts_torque); }

void note_needs(Plan& plan) {
  plan.scene.pair_forces =
      plan.snapshot.any() || !plan.fields.empty() || any_probe_needs(plan, SCREE_NEEDS_CONTACTS);
  plan.scene.sliding_work = plan.snapshot.sliding_work;
  plan.scene.orientations =
      any_probe_needs(plan, SCREE_NEEDS_ORIENTATIONS) || any_law(plan, &depends_on_orientations);
}

// Without the audit, elastic and dissipated energies are not computed.
void check_audit(const document::Table& root, const Plan& plan) {
  if (plan.scene.audit) return;
  const auto refuse = [&](const std::string& user) {
    throw root.table("time").error("energy_audit", fmt::format("{} needs the energy audit", user),
                                   "set energy_audit = true, or remove it");
  };
  if (plan.snapshot.sliding_work) refuse("snapshot.sliding_work");
  for (const Stage& stage : plan.stages)
    if (stage.until.reads_energies()) refuse(fmt::format("the condition of stage '{}'", stage.name));
  for (const ProbePlan& probe : plan.probes)
    if (needs(probe, plan, SCREE_NEEDS_ENERGY)) refuse(fmt::format("the probe '{}'", probe.name));
  for (const Expectation& e : plan.expectations)
    if (needs_energy_audit(e.quantity)) refuse(fmt::format("the [[expect]] of '{}'", e.quantity));
}

void check_pictures(const document::Table& root, const Plan& plan) {
  if (pictures::has_pictures() || !plan.snapshot.any()) return;
  throw root.error(
      "snapshot", fmt::format("{}, but the scene requests them", pictures::no_pictures),
      fmt::format("leave [snapshot] out (--set 'snapshot={{}}'), or {}", pictures::no_pictures_cure));
}

}  // namespace scree::scenario
