#include "atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/descriptor.hpp>
#include <scree/files/text_file.hpp>

namespace scree::pictures {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error_number) {
  const bool full = error_number == ENOSPC || error_number == EDQUOT;
  const char* cure = full ? "free space or choose another output directory"
                          : "check the path and its permissions or choose another output directory";
  throw Error(fmt::format("{}: cannot be written ({}); {}", file.string(), std::strerror(error_number), cure),
              full ? ExitStatus::failure : ExitStatus::bad_input);
}

// But not what it is in: a directory of results that was removed is not made anew.
void create_directory_of(const std::filesystem::path& file) {
  if (!file.has_parent_path()) return;
  std::error_code error;
  std::filesystem::create_directory(file.parent_path(), error);
  if (error) fail(file, error.value());
}

}  // namespace

void write_atomically(const std::filesystem::path& file, std::string_view bytes) {
  create_directory_of(file);
  const std::string temporary = file.string() + files::part_suffix;
  files::Descriptor open_file = files::create_file(temporary.c_str());
  if (!open_file.is_open()) fail(file, errno);
  int error_number = files::write_all(open_file, bytes);
  if (::close(open_file.release()) != 0 && error_number == 0) error_number = errno;
  if (error_number == 0 && std::rename(temporary.c_str(), file.c_str()) != 0) error_number = errno;
  if (error_number == 0) return;
  ::unlink(temporary.c_str());
  fail(file, error_number);
}

}  // namespace scree::pictures
