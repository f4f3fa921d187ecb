#include "plugins/plugin_call.hpp"
#include "walls/boundaries.hpp"
#include "walls/boundary_checks.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree {

WallEquations Boundaries::linear_walls(double time, const std::vector<scree_plane>& planes,
                                       const std::vector<scree_frame>& frames) const {
  WallEquations equations;
  for (const scree_plane& plane : planes) {
    scree_linear_wall prescribed = {};
    std::copy_n(plane.normal, 3, prescribed.direction);
    equations.walls.push_back(prescribed);
  }
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    scree_linear_wall without = {};
    without.direction[dimension_ - 1] = 1;
    if (surfaces_.masses[s] > 0) without.free = SCREE_NO_EQUATION;
    equations.walls.push_back(without);
  }
  equations.stiffness.assign(equations.walls.size() * equations.walls.size(), 0.0);
  for (const Member& member : members_)
    if (member.plugin.interface().linear) linearise(member, time, planes, frames, equations);
  return equations;
}

void Boundaries::linearise(const Member& member, double time, const std::vector<scree_plane>& at,
                           const std::vector<scree_frame>& frames, WallEquations& equations) const {
  // Numbers of its walls among all.
  std::vector<std::size_t> number;
  for (std::size_t w = 0; w < member.plugin.instance().plane_count; ++w)
    number.push_back(member.first_plane + w);
  for (std::size_t s = 0; s < member.plugin.instance().surface_count; ++s)
    number.push_back(at.size() + member.first_surface + s);
  const std::size_t count = number.size(), all = equations.walls.size();
  std::vector<scree_linear_wall> walls;
  for (const std::size_t w : number) walls.push_back(equations.walls[w]);
  std::vector<double> stiffness(count * count, 0.0);
  state_equations(member, time, at, frames,
                  {sizeof(scree_linear_walls), std::uint32_t(count), walls.data(), stiffness.data()});
  for (std::size_t w = 0; w < count; ++w) {
    const std::span<const double> row(stiffness.data() + w * count, count);
    if (const std::string problem = problem_of(walls[w], row); !problem.empty())
      throw Error(fmt::format("boundary plug-in {}, wall {}: its linear equation has {}; correct the plug-in",
                              member.plugin_name(), wall_name(number[w]), problem));
    if (walls[w].turns && number[w] < at.size())
      throw Error(
          fmt::format("boundary plug-in {}, wall {}: its linear equation turns a plane; correct the plug-in",
                      member.plugin_name(), wall_name(number[w])));
    equations.walls[number[w]] = walls[w];
    if (walls[w].free != SCREE_FREE) continue;
    for (std::size_t other = 0; other < count; ++other)
      equations.stiffness[number[w] * all + number[other]] = row[other];
  }
}

// The plug-in gets copies of planes, frames and state, into which it may write.
void Boundaries::state_equations(const Member& member, double time, const std::vector<scree_plane>& at,
                                 const std::vector<scree_frame>& frames_at,
                                 const scree_linear_walls& walls) const {
  const auto own = at.begin() + std::ptrdiff_t(member.first_plane);
  std::vector<scree_plane> planes(own, own + std::ptrdiff_t(member.plugin.instance().plane_count));
  const auto frame = frames_at.begin() + std::ptrdiff_t(member.first_surface);
  std::vector<scree_frame> frames(frame, frame + std::ptrdiff_t(member.plugin.instance().surface_count));
  std::vector<double> state = member.state;
  scree_boundary_energy energy = {};
  scree_boundary_step step = step_of(member, planes, state, time, 0, energy);
  step.frames = frames.data();
  plugin_call(member.plugin_name(), "linear",
              [&] { member.plugin.interface().linear(member.plugin.storage(), &step, &walls); });
}

}  // namespace scree
