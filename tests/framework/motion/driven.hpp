#pragma once

#include <string>
#include <vector>

#include <scree/scene.hpp>

namespace scree::test {

inline constexpr Integration integrators[] = {Integration::velocity_verlet, Integration::position_verlet,
                                              Integration::fourth_order, Integration::predictor_corrector};

inline BodyGroup group_of(const std::string& name, const std::vector<std::uint32_t>& bodies) {
  BodyGroup group;
  group.name = name;
  group.bodies = bodies;
  return group;
}

constexpr freedom::Mask bit(int k) { return freedom::Mask(1u << k); }

}  // namespace scree::test
