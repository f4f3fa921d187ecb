#pragma once

#include <cmath>
#include <string>

#include <scree/plugin/abi.h>
#include <scree/plugin/declaration.hpp>
#include <scree/plugin/walls.hpp>

namespace scree {

// A height along an axis that a probe is given in m, or as a share of the length between the two walls that
// are normal to the axis, when the probe starts:
//
//   scree::LayerHeight at = {"at", "at_share"};
//   in declare   at.declare(d, "centre of the layer", "the same as a share of the length between the walls");
//   in start     if (const std::string problem = at.find(view, axis, height); !problem.empty()) return problem;
struct LayerHeight {
  const char* key;
  const char* share_key;
  double height = 0;  // (m)
  double share = -1;  // 0 to 1; below 0 if the height is given

  void declare(Declaration& d, const char* doc, const char* share_doc) {
    d.number(key, height, "m", any_number, doc).or_else(share_key);
    d.number(share_key, share, "", coefficient, share_doc).or_else(key);
  }

  // Sets the height (m). Returns the problem and a remedy, or "" without one.
  std::string find(const scree_view& view, int axis, double& found) const {
    found = height;
    if (share < 0) return "";
    const std::span<const scree_plane> walls(view.planes, view.plane_count);
    const double from = wall_height(walls, axis, 1), to = wall_height(walls, axis, -1);
    if (std::isnan(to - from))
      return std::string(share_key) + " needs walls at both ends of " + "xyz"[axis] + "; give " + key +
             " (m), or add the walls";
    found = from + share * (to - from);
    return "";
  }
};

}  // namespace scree
