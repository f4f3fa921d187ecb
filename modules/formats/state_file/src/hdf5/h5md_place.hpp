#pragma once

#include <optional>
#include <string>

namespace scree::state_file {

// Where an array "bodies/<name>" lies in the layout of H5MD 1.1 (https://www.nongnu.org/h5md/h5md.html).
struct H5mdPlace {
  std::string element;  // "particles/bodies/position"
  bool as_frame;        // its first index counts times, of which a state has one

  std::string dataset() const { return as_frame ? element + "/value" : element; }
};

// None for paths that have no place there.
std::optional<H5mdPlace> h5md_place(const std::string& path);

// The path of the array that lies at "particles/bodies/position/value", say; none if no array does.
std::optional<std::string> path_at(const std::string& dataset);

}  // namespace scree::state_file
