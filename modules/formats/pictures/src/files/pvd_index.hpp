#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scree::pictures {

// A ParaView collection (.pvd): the file and the time of each frame.
class PvdIndex {
 public:
  // Reads the entries whose files still exist; empty if there is no such collection.
  explicit PvdIndex(std::filesystem::path pvd_file);

  // Adds a file, by its name in the directory of the collection, or updates its time (s).
  void put(const std::string& file_name, double time);

  // Time of a file (s); empty if it is not listed.
  std::optional<double> time_of(const std::string& file_name) const;

  // Writes the collection, sorted by time, then by name.
  void save();

 private:
  struct Entry {
    double time;
    std::string file_name;
  };

  std::filesystem::path pvd_file_;
  std::vector<Entry> entries_;
};

}  // namespace scree::pictures
