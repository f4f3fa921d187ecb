#pragma once

#include <cstddef>
#include <filesystem>

#include <scree/files/descriptor.hpp>
#include <scree/run/run_directory.hpp>

namespace scree::run {

// Room on the disk, kept by a file so that the record of a run can still be written when the disk is full.
class SpareRoom {
 public:
  static constexpr const char* file_name = ".room";
  static constexpr std::size_t size = 1u << 16;  // (bytes) besides that of the present record

  SpareRoom() = default;
  ~SpareRoom() { release(); }
  SpareRoom(const SpareRoom&) = delete;
  SpareRoom& operator=(const SpareRoom&) = delete;

  // Lists the file in a directory, and keeps room for its record, a file which is there. Throws Error (failure) if the disk has
  // no room for it. Where a file system or a limit on file sizes does not allow such a file, there is none.
  void reserve(const RunDirectory& directory, const char* record);
  // Gives the room back. A file of another process that has the name by now stays.
  void release();

 private:
  std::filesystem::path path_;
  files::Descriptor file_;
};

}  // namespace scree::run
