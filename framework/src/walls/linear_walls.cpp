#include "plugins/plugin_call.hpp"
#include "walls/boundaries.hpp"
#include "walls/boundary_checks.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree {

WallEquations Boundaries::linear_walls(double time, const std::vector<scree_plane>& planes) const {
  WallEquations equations;
  for (const scree_plane& plane : planes) {
    scree_linear_plane prescribed = {};
    std::copy_n(plane.normal, 3, prescribed.direction);
    equations.walls.push_back(prescribed);
  }
  equations.stiffness.assign(planes.size() * planes.size(), 0.0);
  for (const Member& member : members_)
    if (member.plugin.interface().linear) linearise(member, time, planes, equations);
  return equations;
}

void Boundaries::linearise(const Member& member, double time, const std::vector<scree_plane>& at,
                           WallEquations& equations) const {
  const std::size_t first = member.first_plane, count = member.plugin.instance().plane_count;
  const auto own = at.begin() + std::ptrdiff_t(first);
  // Copies, into which the plug-in may write.
  std::vector<scree_plane> planes(own, own + std::ptrdiff_t(count));
  std::vector<double> state = member.state, stiffness(count * count, 0.0);
  scree_boundary_energy energy = {};
  const scree_boundary_step step = step_of(member, planes, state, time, 0, energy);
  const scree_linear_planes stated = {sizeof(stated), std::uint32_t(count), equations.walls.data() + first,
                                      stiffness.data()};
  plugin_call(member.plugin_name(), "linear",
              [&] { member.plugin.interface().linear(member.plugin.storage(), &step, &stated); });
  for (std::size_t w = 0; w < count; ++w) {
    const std::span<const double> row(stiffness.data() + w * count, count);
    if (const std::string problem = problem_of(stated.planes[w], row); !problem.empty())
      throw Error(fmt::format("boundary plug-in {}, wall {}: its linear equation has {}; correct the plug-in",
                              member.plugin_name(), names_[first + w], problem));
    if (stated.planes[w].free)
      std::copy(row.begin(), row.end(),
                equations.stiffness.begin() + std::ptrdiff_t((first + w) * at.size() + first));
  }
}

}  // namespace scree
