#include "start.hpp"

#include "driven_walls.hpp"
#include "linear.hpp"

#include <scree/run/set_up.hpp>

namespace scree::spectrum {

void check_before_stages(const scenario::Plan& plan, const SpectrumPlan& spectrum,
                         const std::vector<Method>& methods) {
  const auto simulation = run::set_up_with_last_stage(plan);
  if (!simulation) return;
  const Start start{plan, spectrum, scene_in_stage(plan.scene, plan.stages, plan.stages.size()),
                    simulation->state()};
  const DrivenWalls checked(start);
  if (methods.size() == 1 && methods[0] == Method::linear) check_linear(start);
}

}  // namespace scree::spectrum
