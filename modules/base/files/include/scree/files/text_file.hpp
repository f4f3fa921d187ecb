#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <scree/error.hpp>

namespace scree::files {

// Error for a file that cannot be read, at its path. From the code a caller can derive another cure.
class ReadError : public Error {
 public:
  ReadError(std::string place, std::string problem, std::string cure, int code)
      : Error(std::move(place), std::move(problem), std::move(cure)), code_(code) {}
  // Value of errno; EFBIG for a file above the limit.
  int code() const { return code_; }

 private:
  int code_;
};

// Error (failure) for a file that cannot be written, at its path.
class WriteError : public Error {
 public:
  WriteError(std::string place, std::string problem, std::string cure, int code)
      : Error(std::move(place), std::move(problem), std::move(cure), ExitStatus::failure), code_(code) {}
  // Value of errno.
  int code() const { return code_; }

 private:
  int code_;
};

inline constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();

// Reads a file of at most `largest` bytes. Without a limit only regular files are read, since a device may
// have no end. Throws ReadError.
std::string read_text(const std::filesystem::path& path, std::size_t largest = any_size);

// Opens a regular file for reading; the caller closes it. Throws ReadError.
std::FILE* open_text(const std::filesystem::path& path);

// Suffix of the temporary file of write_atomically().
inline constexpr const char* part_suffix = ".part";

// Writes a temporary file in the same directory and renames it, so that the file is either complete or
// unchanged. Throws WriteError after removing the temporary file.
void write_atomically(const std::filesystem::path& path, std::string_view text);

// The same, in a folder that is created if it is missing, but none above: a directory of results that was
// removed is not made anew.
void write_in_folder(const std::filesystem::path& path, std::string_view text);

}  // namespace scree::files
