#pragma once

#include <string>
#include <vector>

#include <scree/domain.hpp>
#include <scree/particles.hpp>
#include <scree/scene.hpp>
#include <scree/state.hpp>

namespace scree {

// What a new simulation takes over from the state of another, besides the bodies, and what it leaves out.
// Histories of contacts are matched by the names of materials and by the plug-in of their law, walls by the
// names of boundaries.
struct Branching {
  bool histories = true, walls = true, orientations = true;
};

// The bodies of a state as they are now. Their material is an index into materials_of(state).
std::vector<Body> present_bodies(const State& state);
std::vector<std::string> materials_of(const State& state);
double time_of(const State& state);  // (s)
// Its periodic axes; along others it has no extent.
Domain domain_of(const State& state);

}  // namespace scree
