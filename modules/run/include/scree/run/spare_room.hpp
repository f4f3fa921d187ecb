#pragma once

#include <cstddef>
#include <filesystem>

namespace scree::run {

// Room on the disk, kept by a file so that the record of a run can still be written when the disk is full.
class SpareRoom {
 public:
  static constexpr const char* file_name = ".room";
  static constexpr std::size_t size = 1u << 16;  // (bytes) besides what the caller knows to need

  SpareRoom() = default;
  ~SpareRoom() { release(); }
  SpareRoom(const SpareRoom&) = delete;
  SpareRoom& operator=(const SpareRoom&) = delete;

  // Throws Error (failure) if the disk has no room for it. Where a file system or a limit on file sizes does not
  // allow such a file, there is none.
  void reserve(const std::filesystem::path& file, std::size_t bytes);
  // Gives the room back.
  void release();

 private:
  std::filesystem::path file_;
};

}  // namespace scree::run
