#pragma once

#include "bodies/body_facts.hpp"

#include <scree/plugin_host.hpp>
#include <scree/scene.hpp>
#include <scree/state.hpp>

namespace scree {

// A scene for another process of the same program, after the first force evaluation: without springs, which
// are placed, and without bodies, of which it has the facts. And the scene in such a message, with plug-ins
// of a host.
State message_of(const Scene& scene, const BodyFacts& bodies);
Scene scene_of(const State& message, PluginHost& host);
BodyFacts facts_in(const State& message);

}  // namespace scree
