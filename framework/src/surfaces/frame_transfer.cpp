#include "surfaces/frame_transfer.hpp"

#include <cstddef>

#include <scree/wall_surfaces.hpp>

namespace scree {

void transfer_frames(const StateTransfer& state, std::vector<scree_frame>& frames) {
  constexpr std::size_t stride = sizeof(scree_frame) / sizeof(double);
  const auto column = [&](const char* name, const char* unit, auto member, int components) {
    double* const first = frames.empty() ? nullptr : frames[0].*member;
    state.vectors(name, unit, {first, stride, frames.size(), 0, components}, 0, components);
  };
  column("position", "m", &scree_frame::position, 3);
  column("orientation", "1", &scree_frame::orientation, 4);
  column("velocity", "m/s", &scree_frame::velocity, 3);
  column("spin", "rad/s", &scree_frame::spin, 3);
  column("mid_velocity", "m/s", &scree_frame::mid_velocity, 3);
  column("mid_spin", "rad/s", &scree_frame::mid_spin, 3);
  for (const scree_frame& frame : frames)
    if (state.restoring() && !problem_of(frame).empty())
      state.refuse("orientation", "has a quaternion whose length is not 1");
}

}  // namespace scree
