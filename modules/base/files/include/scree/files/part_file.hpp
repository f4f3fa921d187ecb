#pragma once

#include <filesystem>

namespace scree::files {

// A file that gets its name only when it is complete and on the disk. Until then it is <name>.part in the
// same folder, where a file of an interrupted program is replaced and a symbolic link is removed, not
// followed. Every function throws Error (failure) "path: what is wrong; what to do", and leaves an earlier
// file whole.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path path);
  // Removes the file unless it was committed.
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  // Open for reading and writing, until the end of this object.
  int descriptor() const { return descriptor_; }
  // Waits until the bytes are on the disk, and gives the file its name.
  void commit();

 private:
  std::filesystem::path path_, temporary_;
  int descriptor_ = -1;
  bool committed_ = false;
};

}  // namespace scree::files
