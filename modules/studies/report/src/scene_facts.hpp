#pragma once

#include "results.hpp"

namespace scree::report {

// What a scene is made of, from its record and its scenario.
std::string scene_facts(const Results& results);

}  // namespace scree::report
