#pragma once

#include "support/command_line.hpp"

#include <functional>

#include <scree/error.hpp>

namespace scree::tool {

// Calls work and returns its status. Every error becomes one line on stderr and its status; so does standard
// output that cannot be written.
ExitStatus guarded(const std::function<ExitStatus()>& work);

// Adds verbs to the command line of scree and does what the arguments ask for, guarded.
ExitStatus run_program(int argc, char** argv, const std::function<void(CommandLine&)>& add_verbs);

}  // namespace scree::tool
