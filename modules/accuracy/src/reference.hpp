#pragma once

#include <vector>

#include <scree/accuracy/study.hpp>
#include <scree/scenario/trial.hpp>

namespace scree::accuracy {

// The limit of values at steps h, h/2, h/4, by the order that they show (Richardson), and how far it is from
// the last of them.
struct Limit {
  double value, uncertainty;
};
Limit extrapolate(double at_h, double at_half, double at_quarter);

// What the trials of a plan with the steps h, h/2, h/4 say of its expectations: closed forms where they name
// them, 0 for residuals, else the limit. The last quantity is "positions".
std::vector<Quantity> reference_quantities(const scenario::Plan& plan,
                                           const std::vector<scenario::Trial>& trials);
// The limit of the bodies' positions (m).
std::vector<Vec3> reference_positions(const std::vector<scenario::Trial>& trials);

double mean_radius(const scenario::Plan& plan);

}  // namespace scree::accuracy
