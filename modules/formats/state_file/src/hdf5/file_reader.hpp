#pragma once

#include "../placed_array.hpp"
#include "handle.hpp"

#include <filesystem>
#include <string>
#include <unordered_set>
#include <vector>

namespace scree::state_file {

// Finds the arrays that FileWriter has written, without reading their values. Every function throws Error
// without path and cure.
class FileReader {
 public:
  explicit FileReader(const std::filesystem::path& file);

  // Paths of the datasets where a state has arrays, from the root without a leading '/'. Refuses links there
  // that FileWriter does not make: soft ones, second names of groups, groups in more than some ten others.
  std::vector<std::string> datasets();
  // Type, shape, unit and place of a dataset that lies in one piece. as_frame: it has a leading dimension of
  // 1.
  PlacedArray array(const std::string& name, bool as_frame) const;

 private:
  void visit(hid_t group, const std::string& name, int depth);
  void visit_link(hid_t group, const std::string& name, const H5L_info_t& link, int depth);

  Handle file_;
  std::vector<std::string> found_;
  std::unordered_set<haddr_t> groups_;
};

}  // namespace scree::state_file
