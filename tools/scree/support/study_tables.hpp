#pragma once

#include <scree/scenario/study_table.hpp>

namespace scree::tool {

// The tables that studies read in a scenario. A new study with a table adds it here.
const scenario::StudyTables& study_tables();

}  // namespace scree::tool
