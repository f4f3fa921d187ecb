#pragma once

#include "handle.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <scree/state.hpp>

namespace scree::state_file {

// Attributes of a dataset: its unit as in the module `units` of H5MD. Without a unit in the state it is "1",
// with a label that says so.
inline constexpr const char* unit_attribute = "unit";
inline constexpr const char* unit_attribute_of_format_1 = "units";  // with the unit as in a state
inline constexpr const char* label_attribute = "label";
// Lengths of texts, if one of them ends with a character 0, which reads like padding.
inline constexpr const char* lengths_attribute = "lengths";

// Writes an HDF5 file dataset by dataset. Names are paths from the root without a leading '/'. No times are
// stored, so that equal states give equal bytes. Datasets lie in one piece and are not compressed, so that a
// reader can compare the size that a dataset claims with the size of the file. Shuffle and deflate at level 1
// would save a third of 288 MB (10^6 bodies with 4.5 pairs each), but take 6 s instead of 0.3 to write and
// 1.8 s instead of 0.2 to read. Every function throws Error without path and cure.
class FileWriter {
 public:
  // Replaces the content of a file by room for what comes before HDF5 (bytes, 0 or 512 and more), and an
  // empty file.
  explicit FileWriter(const std::filesystem::path& file, std::size_t user_block);
  // Adds to a file that was closed.
  static FileWriter existing(const std::filesystem::path& file);
  FileWriter(FileWriter&&) = delete;
  // A file that was not closed stays incomplete.
  ~FileWriter();

  // Opens a group. It is made if it is missing, with the groups that contain it.
  Handle group(const std::string& name);
  // Writes an array; as_frame: with a leading dimension of 1, the time.
  void array(const std::string& name, const StateArray& array, bool as_frame);
  // Writes an array, which is not of texts, as the frame of this number of a dataset that has those before
  // it. A label, if there is one, is written instead of the unit.
  void append(const std::string& name, const StateArray& array, std::uint64_t frame,
              const std::string& label);
  // A second name of a dataset.
  void link(const std::string& existing, const std::string& name);
  // Writes the rest, and closes the file.
  void close();

 private:
  explicit FileWriter(Handle file);
  Handle growing(const std::string& name, hid_t type, const StateArray& array, const std::string& label);
  template <class T>
  void write(hid_t group, const std::string& name, const std::vector<T>& numbers, hid_t space,
             const StateArray& array);
  Handle dataset(hid_t group, const std::string& name, hid_t type, hid_t space, const StateArray& array);

  Handle file_, group_properties_, dataset_properties_;
  bool complete_ = false;
};

// Shape of an array in a file; as_frame: with a leading dimension of 1.
Handle dataspace(const std::vector<std::size_t>& shape, bool as_frame);

}  // namespace scree::state_file
