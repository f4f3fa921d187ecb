#include "plugins/plane_transfer.hpp"

namespace scree {

void transfer_planes(const StateTransfer& state, std::vector<scree_plane>& planes) {
  const auto column = [&](const char* name, const char* unit, double(scree_plane::*member)[3]) {
    double* const first = planes.empty() ? nullptr : planes[0].*member;
    state.vectors(name, unit, {first, sizeof(scree_plane) / sizeof(double), planes.size(), 0, 3}, 0, 3);
  };
  column("point", "m", &scree_plane::point);
  column("normal", "1", &scree_plane::normal);
  column("velocity", "m/s", &scree_plane::velocity);
  column("mid_velocity", "m/s", &scree_plane::mid_velocity);
}

}  // namespace scree
