#pragma once

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <unistd.h>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::files {

// A file in the folder of the system for such files, open for writing, and removed at the end of its scope.
struct TemporaryFile {
  std::string path = (std::filesystem::temp_directory_path() / "scree-XXXXXX").string();
  int descriptor = mkostemp(path.data(), O_CLOEXEC);

  // Throws Error (failure) if there is no room for it.
  TemporaryFile() {
    if (descriptor < 0)
      throw Error(fmt::format("{}: cannot be written ({}); free space there", path, std::strerror(errno)),
                  ExitStatus::failure);
  }
  ~TemporaryFile() {
    close(descriptor);
    unlink(path.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
};

}  // namespace scree::files
