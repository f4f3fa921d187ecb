#include <cerrno>
#include <cstdio>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

#include <scree/files/descriptor.hpp>
#include <scree/files/text_file.hpp>

namespace scree::files {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t block_size = 1u << 16;

ReadError not_opened(const fs::path& path, int code) {
  std::error_code failed;
  if (!fs::exists(path, failed)) return {path.string(), "there is no such file", "check the path", code};
  return {path.string(), "cannot be opened", "check its permissions", code};
}

// Reads a file to its end, or at most one block beyond `largest`.
std::string read_blocks(std::FILE* file, std::size_t expected, std::size_t largest) {
  std::string text;
  text.reserve(expected);
  std::vector<char> block(block_size);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file)) {
    text.append(block.data(), count);
    if (text.size() > largest) break;
  }
  return text;
}

void write_whole(const fs::path& path, const fs::path& temporary, std::string_view text) {
  const auto unopened = [&](int code) {
    return WriteError(path.string(), "cannot be opened for writing",
                      "check that its folder exists and is writable", code);
  };
  const Descriptor file = create_file(temporary.c_str());
  if (!file.is_open()) throw unopened(errno);
  if (const int code = write_all(file, text))
    throw WriteError(path.string(), "could not be written in full", "check the space on the disk", code);
  std::error_code failed;
  fs::rename(temporary, path, failed);
  if (failed) throw unopened(failed.value());
}

// Throws ReadError.
std::FILE* opened(const fs::path& path) {
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file) throw not_opened(path, errno);
  return file;
}

void refuse_devices(const fs::path& path) {
  std::error_code failed;
  if (const fs::file_status status = fs::status(path, failed);
      fs::exists(status) && !fs::is_regular_file(status))
    throw ReadError(path.string(), "is not a regular file", "give a text file", EINVAL);
}

}  // namespace

std::FILE* open_text(const fs::path& path) {
  refuse_devices(path);
  return opened(path);
}

std::string read_text(const fs::path& path, std::size_t largest) {
  std::error_code failed;
  const bool regular = fs::is_regular_file(fs::status(path, failed));
  if (largest == any_size) refuse_devices(path);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(opened(path), std::fclose);
  std::uintmax_t size = regular ? fs::file_size(path, failed) : 0;
  if (failed) size = 0;
  std::string text;
  const auto too_large = [&](const std::string& problem, int code) {
    return ReadError(path.string(), problem, "cut it to the part that is needed", code);
  };
  try {
    text = read_blocks(file.get(), size <= largest ? size : 0, largest);
  } catch (const std::bad_alloc&) {
    throw too_large("does not fit into memory", ENOMEM);
  } catch (const std::length_error&) {
    throw too_large("does not fit into memory", ENOMEM);
  }
  if (text.size() > largest) throw too_large(fmt::format("is larger than {} bytes", largest), EFBIG);
  if (std::ferror(file.get()) != 0 || text.size() < size)
    throw ReadError(path.string(), "cannot be read to its end",
                    "check the disk, and that nothing is writing the file", errno != 0 ? errno : EIO);
  return text;
}

void write_atomically(const fs::path& path, std::string_view text) {
  fs::path temporary = path;
  temporary += part_suffix;
  try {
    write_whole(path, temporary, text);
  } catch (...) {
    unlink(temporary.c_str());  // not a directory of that name
    throw;
  }
}

void write_in_folder(const fs::path& path, std::string_view text) {
  std::error_code failed;  // then the file cannot be written either
  if (path.has_parent_path()) fs::create_directory(path.parent_path(), failed);
  write_atomically(path, text);
}

}  // namespace scree::files
