#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include <scree/error.hpp>

namespace scree::files {

// A file that cannot be read: "path: what is wrong; what to do". The code lets a caller word a cure of its
// own.
class ReadError : public Error {
 public:
  ReadError(const std::string& line, int code) : Error(line), code_(code) {}
  // As errno; EFBIG for a file above the limit.
  int code() const { return code_; }

 private:
  int code_;
};

inline constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();

// The bytes of a file of at most `largest`. Without a limit only a regular file is read, since a device need
// not end. Throws ReadError.
std::string read_text(const std::filesystem::path& path, std::size_t largest = any_size);

// Behind the name of a file that write_atomically() has not finished.
inline constexpr const char* part_suffix = ".part";

// Writes under a temporary name in the same directory, then renames: the file is there whole, or as it was.
// Throws Error (failure) "path: what is wrong; what to do", with the temporary file removed.
void write_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace scree::files
