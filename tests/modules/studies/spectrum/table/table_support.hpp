#pragma once

#include "plan_support.hpp"

#include <string>
#include <vector>

#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::test {

inline const std::string driven =
    "[time]\nstep = 1e-5\n[[material]]\nname = 'grain'\ndensity = 1000\n"                          // 1 to 5
    "[[contact]]\nplugin = 'linear_spring_dashpot'\nnormal_stiffness = 1e3\nnormal_damping = 0\n"  // 6 to 9
    "[[particle]]\nposition = [0, 0, 0.01]\nradius = 0.01\n"                                       // 10 to 12
    "[[boundary]]\nplugin = 'plane'\nname = 'floor'\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"      // 13 to 17
    "[[probe]]\nplugin = 'particles'\nids = [1]\n"                                                 // 18 to 20
    "[spectrum]\ndrive = 'floor.displacement'\namplitude = 1e-8\nobserve = ['particles.z_1']\n"    // 21 to 24
    "from_hz = 10\nto_hz = 50\nstep_hz = 10\n";                                                    // 25 to 27

inline scenario::Plan plan_with_spectrum(const std::string& text,
                                         const std::vector<std::string>& overrides = {}) {
  return plan_of(text, overrides, {spectrum::spectrum_table()});
}

inline std::string refused(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return refusal(text, overrides, {spectrum::spectrum_table()});
}

inline void refuses(const std::vector<std::string>& overrides, const std::string& problem,
                    const std::string& cure) {
  const std::string line = refused(driven, overrides);
  CAPTURE(line, problem, cure);
  CHECK(line.find(problem) != std::string::npos);
  CHECK(line.find(cure) != std::string::npos);
}

}  // namespace scree::test
