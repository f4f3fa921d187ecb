#include "walls/plane_transfer.hpp"

#include <cmath>

namespace scree {

namespace {

void check_normals(const StateTransfer& state, const std::vector<scree_plane>& planes) {
  constexpr double tolerance = 1e-6;  // far above the round-off of walls that turn
  for (const scree_plane& plane : planes) {
    const auto& n = plane.normal;
    if (!(std::abs(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1) <= tolerance))
      state.refuse("normal", "has a vector whose length is not 1");
  }
}

}  // namespace

void transfer_planes(const StateTransfer& state, std::vector<scree_plane>& planes) {
  const auto column = [&](const char* name, const char* unit, double(scree_plane::*member)[3]) {
    double* const first = planes.empty() ? nullptr : planes[0].*member;
    state.vectors(name, unit, {first, sizeof(scree_plane) / sizeof(double), planes.size(), 0, 3}, 0, 3);
  };
  column("point", "m", &scree_plane::point);
  column("normal", "1", &scree_plane::normal);
  if (state.restoring()) check_normals(state, planes);
  column("velocity", "m/s", &scree_plane::velocity);
  column("mid_velocity", "m/s", &scree_plane::mid_velocity);
}

}  // namespace scree
