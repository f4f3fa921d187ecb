#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <scree/files/descriptor.hpp>

namespace scree::run {

// A text file that grows line by line. Lines wait in a buffer until it is full or flushed. If the file cannot
// be written, it is cut back to its last whole line, and Error (failure) is thrown; likewise if it was moved
// or removed meanwhile. Links are not followed.
class LineFile {
 public:
  // Creates the file, with its folder; replaces a file of that name.
  explicit LineFile(const std::filesystem::path& path);
  // Goes on behind a line that ends after so many bytes. Throws Error if there is none. What follows it stays
  // until cut() drops it, which comes before the first line is added.
  LineFile(const std::filesystem::path& path, std::uint64_t bytes);
  void cut();

  // A line ends with '\n'.
  void add(std::string_view line);
  void flush();

  const std::filesystem::path& path() const { return path_; }
  // Bytes that are in the file.
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::filesystem::path path_;
  files::Descriptor file_;
  std::string buffer_;
  std::uint64_t bytes_ = 0;
};

}  // namespace scree::run
