#pragma once

#include <functional>

#include <scree/error.hpp>
#include <scree/quasi_static/follow.hpp>

namespace scree::tool {

// Calls work with options that show progress and warnings and let Ctrl-C stop it, then prints the result.
// Returns the exit status.
ExitStatus report_load(bool quiet,
                       const std::function<quasi_static::FollowedLoad(quasi_static::FollowOptions)>& work);

}  // namespace scree::tool
