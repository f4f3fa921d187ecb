#pragma once

#include <scree/document/table.hpp>
#include <scree/scenario/table_keys.hpp>

namespace scree::scenario {

// A time between outputs (s). Throws Error at the key if it is shorter than the time step (s).
double read_interval(const document::Table& table, const Key& key, double step);

}  // namespace scree::scenario
