#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scree::snapshot {

// A ParaView collection: which file holds which time.
class PvdIndex {
 public:
  // The entries of the collection whose files still exist; empty where there is no such file.
  explicit PvdIndex(std::filesystem::path pvd_file);

  // Adds a file, given by its name in the collection's directory, or gives it a new time (s).
  void put(const std::string& file_name, double time);

  // Time of a file (s), where it is listed.
  std::optional<double> time_of(const std::string& file_name) const;

  // Writes the collection in order of time, then of name.
  void save();

 private:
  struct Entry {
    double time;
    std::string file_name;
  };

  std::filesystem::path pvd_file_;
  std::vector<Entry> entries_;
};

}  // namespace scree::snapshot
