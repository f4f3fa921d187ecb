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
  State state() const;

 private:
  // Throws Error with the path and a cure: another one for a file that was removed meanwhile.
  [[noreturn]] void refuse(const std::string& problem) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  Seal seal_;
};

// Name of an open file which stays that of the same file if another one takes its path.
std::filesystem::path name_of(int descriptor);

// The places of all arrays of an open file, found in a child process: a file that anyone may have written can crash
// HDF5, or keep it busy for ever. Where there is no process to be had, they are found here. Throws Error without path
// and cure.
std::vector<PlacedArray> places_in(int descriptor, StateBackend& backend);

}  // namespace scree::state_file
