#pragma once

#include <string>

#include <scree/parameters.hpp>

namespace scree::tool {

// Sets a parameter of a plug-in from "KEY=VALUE" of the command line: a number or one of its words. Throws
// Error that names the text.
void set_value(Parameters& parameters, const std::string& text);

}  // namespace scree::tool
