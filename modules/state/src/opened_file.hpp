#pragma once

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
  std::filesystem::path path_;
  int descriptor_ = -1;
  Seal seal_;
};

// Name of an open file which stays that of the same file if another one takes its path.
std::filesystem::path name_of(int descriptor);

}  // namespace scree::state_file
