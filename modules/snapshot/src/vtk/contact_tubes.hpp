#pragma once

#include <string>

#include <scree/snapshot/frame.hpp>

class vtkRenderer;

namespace scree::snapshot {

// Adds the contacts as bars whose width is proportional to the normal force; sliding ones in red.
void add_contacts(vtkRenderer* renderer, const Frame& frame);

// What the bars mean, for the caption.
std::string contact_note(const Frame& frame);

}  // namespace scree::snapshot
