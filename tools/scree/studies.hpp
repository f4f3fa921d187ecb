#pragma once

#include "support/command_line.hpp"

#include <functional>

#include <scree/error.hpp>

namespace scree::tool {

// Adds the verbs of the companion library scree_studies: their help, and what is wrong with their options,
// need no library.
void add_study_verbs(CommandLine& line, const std::function<ExitStatus()>& do_study);

// Does what the arguments ask for with that library, which is loaded now and, in a build tree, built if it is
// missing. Throws Error if it cannot be.
ExitStatus run_study(int argc, char** argv);

}  // namespace scree::tool
