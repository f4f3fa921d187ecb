#pragma once

#include "backend.hpp"
#include "seal.hpp"

#include <filesystem>

#include <scree/state.hpp>

namespace scree::state_file {

// A state file whose seal is unbroken. Every function throws Error "path: what is wrong; what to do".
class OpenedFile {
 public:
  // Opens the file and checks its seal.
  explicit OpenedFile(std::filesystem::path path);
  ~OpenedFile();
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;

  const Seal& seal() const { return seal_; }
  State state() const { return state(places()); }
  // Where its arrays are, and the state of these.
  std::vector<PlacedArray> places() const;
  State state(const std::vector<PlacedArray>& places) const;

 private:
  // Does what HDF5 or memory may prevent.
  template <class Work>
  auto refusing(const Work& work) const;
  // Throws Error with the path and a cure, which differs for a file that was removed meanwhile.
  [[noreturn]] void refuse(const std::string& problem) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  Seal seal_;
};

// A name of an open file that stays valid if another file takes its path.
std::filesystem::path name_of(int descriptor);

// The places of all arrays of an open file. They are found in a child process, since a foreign file can crash
// HDF5 or keep it busy for ever; if no process can be started, in this one. Throws Error without path and
// cure.
std::vector<PlacedArray> places_in(int descriptor, StateBackend& backend);

}  // namespace scree::state_file
