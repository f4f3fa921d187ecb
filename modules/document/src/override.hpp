#pragma once

#include "document_state.hpp"

#include <cstddef>

namespace scree::document {

// Writes override number into the tree of the document. Throws Error "--set key=value: what is wrong; what to
// do".
void apply_override(DocumentState& state, std::size_t number);

}  // namespace scree::document
