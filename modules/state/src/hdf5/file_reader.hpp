#pragma once

#include "handle.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <scree/state.hpp>

namespace scree::state_file {

// Reads what FileWriter writes. A dataset may claim any size: before memory is taken, its size is compared with
// what it has in the file, that of all datasets with the size of the file, and the memory with a limit.
// Every function throws Error without path and cure.
class FileReader {
 public:
  // `largest`: bytes of memory that the arrays may take.
  FileReader(const std::filesystem::path& file, double largest);

  // Paths of all links, from the root without a leading '/'.
  std::vector<std::string> links() const;
  bool is_group(const std::string& name) const;
  // as_frame: the array has a leading dimension of 1.
  StateArray array(const std::string& name, bool as_frame);

 private:
  template <class T>
  void read(hid_t dataset, const std::string& name, StateArray& array);

  Handle file_;
  std::uint64_t bytes_left_;  // of the file, for further datasets
  double memory_left_;
};

}  // namespace scree::state_file
