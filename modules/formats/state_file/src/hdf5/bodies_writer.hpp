#pragma once

#include "file_writer.hpp"

#include <string>
#include <vector>

#include <scree/state.hpp>

namespace scree::state_file {

// Writes arrays of bodies in the layout of H5MD, with the time and the box of the state.
class BodiesWriter {
 public:
  BodiesWriter(FileWriter& writer, const State& state);

  // Writes an array with one row for each body to its place; false if it has none.
  bool write(const std::string& path, const StateArray& array);

 private:
  void write_box();
  void write_time(const std::string& element);

  FileWriter& writer_;
  const State& state_;
  std::size_t bodies_ = 0, dimension_ = 0;  // both 0 if the state has no positions
  std::string first_;                       // the element whose time the others share
};

// Writes the group that identifies a file as H5MD: version, this program as creator, and the module of units.
void write_h5md_group(FileWriter& writer);

// Of a box with an axis for each boundary, "periodic" or "none".
void write_box_attributes(hid_t box, const std::vector<std::string>& boundary);

}  // namespace scree::state_file
