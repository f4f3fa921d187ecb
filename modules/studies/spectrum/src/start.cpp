#include "start.hpp"

#include "driven_walls.hpp"
#include "linear.hpp"

#include <scree/run/set_up.hpp>

namespace scree::spectrum {

void check_before_stages(const scenario::Plan& plan, const std::vector<Road>& roads) {
  const auto simulation = run::set_up_with_last_stage(plan);
  if (!simulation) return;
  const Start start{plan, scene_in_stage(plan.scene, plan.stages, plan.stages.size()), simulation->state()};
  const DrivenWalls checked(start);
  if (roads.size() == 1 && roads[0] == Road::linear) check_linear(start);
}

}  // namespace scree::spectrum
