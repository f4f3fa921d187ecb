#pragma once

#include <string>

#include <scree/pictures/frame.hpp>

class vtkRenderer;

namespace scree::pictures {

// Adds the contacts as bars with a width proportional to the normal force; sliding contacts are red. strong:
// only contacts above the mean normal force, coloured by it.
void add_contacts(vtkRenderer* renderer, const Frame& frame, bool strong);

// Explanation of the bars, for the caption.
std::string contact_note(const Frame& frame, bool strong);

}  // namespace scree::pictures
