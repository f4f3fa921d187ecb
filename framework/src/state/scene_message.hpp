#pragma once

#include <scree/plugin_host.hpp>
#include <scree/scene.hpp>
#include <scree/state.hpp>

namespace scree {

// A scene for another process of the same program, without selections and springs, which its first force
// evaluation needs no more; and the scene in such a message, with plug-ins of a host.
State message_of(const Scene& scene);
Scene scene_of(const State& message, PluginHost& host);

}  // namespace scree
