#pragma once

#include <scree/document/table.hpp>

namespace scree::scenario {

// Throws Error at the key if this number of bodies does not fit into memory. To be called before anything is
// allocated: a system without memory ends a program without a message.
void check_body_memory(const document::Table& table, std::string_view key, double bodies);

}  // namespace scree::scenario
